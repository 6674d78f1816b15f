// The two file formats behind readImage(). Private to jni/image and the compare command.
#pragma once

#include <string>
#include <vector>

#include "core/files.h"
#include "image/image.h"

namespace vct {

// Larger pictures are refused, on reading and on writing: their size in bytes no longer fits stb's int.
constexpr int maxImageSide = 16384;

enum class ImageFormat { png, exr };

// Throws vct::Error naming the file and the cause.
Bytes readImageFile(const std::string& path);

// By content; throws vct::Error where it is neither.
ImageFormat imageFormat(const std::string& path, const Bytes& bytes);

// Throws vct::Error where a side is 0 or above maxImageSide, or where the pixels are not width x height.
void checkWritable(const std::string& path, const Image& image);

Image decodePng(const std::string& path, const Bytes& bytes);
Image decodeExr(const std::string& path, const Bytes& bytes);

// Throws vct::Error where tinyexr would read outside the file or meet what this project does not read:
// several parts, tiles, deep data, subsampled channels. tinyexr trusts most of what a file says.
void checkExrLayout(const std::string& path, const Bytes& bytes);

}  // namespace vct
