#include "image/files.h"
#include "image/image.h"

namespace vct {

Image readImage(const std::string& path) {
    const Bytes bytes = readImageFile(path);
    return imageFormat(path, bytes) == ImageFormat::png ? decodePng(path, bytes) : decodeExr(path, bytes);
}

}  // namespace vct
