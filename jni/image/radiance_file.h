// Radiance pictures (.hdr), the format of skies that the app reads too.
#pragma once

#include <string>

#include "core/files.h"
#include "image/image.h"

namespace vct {

bool isRadiance(const Bytes& bytes);

// Throws vct::Error naming the file, the cause and the remedy.
Image decodeRadiance(const std::string& path, const Bytes& bytes);

}  // namespace vct
