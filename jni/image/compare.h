// Two pictures within a two-number tolerance, as in Filament's renderdiff.
#pragma once

#include "image/image.h"

namespace vct {

struct Difference {
    float largest = 0.0F;    // of |a - b| over all pixels and channels
    double fraction = 0.0;   // of pixels with a channel that differs by more than maxDifference
    bool comparable = true;  // false: sizes differ, or a value is not finite
    std::string reason;      // why not comparable
};

// PNGs are compared by their encoded values in [0, 1] (so 5/255 is five steps), EXRs by their linear ones:
// the caller passes the images in the space it wants compared.
Difference compareImages(const Image& a, const Image& b, float maxDifference);

// |a - b| scaled so that maxDifference shows as mid-grey.
Image differenceImage(const Image& a, const Image& b, float maxDifference);

}  // namespace vct
