// The file of a sky: a picture of all directions in radiance.
#pragma once

#include <string>

#include "image/image.h"

namespace vct {

// Radiance (.hdr, RGBE) or EXR, by content. Throws vct::Error naming the file, the cause and the remedy; what
// is in the pixels is not looked at.
Image readEnvironment(const std::string& path);

}  // namespace vct
