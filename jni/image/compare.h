// Comparison of two pictures with a tolerance of two numbers, as in Filament's renderdiff.
#pragma once

#include "image/image.h"

namespace vct {

struct Difference {
    float largest = 0.0F;    // largest |a - b| over all pixels and channels
    double fraction = 0.0;   // share of pixels with a channel that differs by more than maxDifference
    bool comparable = true;  // false: sizes differ, or a value is not finite
    std::string reason;      // why the pictures are not comparable
};

// Compares the values as they are. To compare PNGs, the caller passes their encoded values in [0, 1], so that
// 5/255 is five steps; for EXRs it passes linear values.
Difference compareImages(const Image& a, const Image& b, float maxDifference);

// |a - b| scaled so that maxDifference shows as mid-grey.
Image differenceImage(const Image& a, const Image& b, float maxDifference);

}  // namespace vct
