// Reads the picture of a sky: radiance from all directions.
#pragma once

#include <string>

#include "image/image.h"

namespace vct {

// Reads Radiance (.hdr, RGBE) or EXR; the content decides which. Throws vct::Error naming the file, the cause
// and the remedy. Does not check the pixel values.
Image readEnvironment(const std::string& path);

}  // namespace vct
