#include "image/environment_file.h"

#include <cstring>

#include "core/error.h"
#include "image/files.h"
#include "image/radiance_file.h"
#include "scene/gltf.h"

namespace vct {

Image readEnvironment(const std::string& path) {
    const Bytes bytes = readFileFromDisk(path);
    if (isRadiance(bytes)) return decodeRadiance(path, bytes);
    if (bytes.size() >= 4 && std::memcmp(bytes.data(), "\x76\x2F\x31\x01", 4) == 0)
        return decodeExr(path, bytes);
    throw Error("cannot read the sky '" + path + "': " +
                (bytes.empty() ? "the file is empty" : "it is neither a Radiance (.hdr) nor an EXR picture") +
                "; make it again in one of these formats");
}

}  // namespace vct
