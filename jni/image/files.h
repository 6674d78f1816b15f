// The two file formats behind readImage(). Private to jni/image and the compare command.
#pragma once

#include <string>

#include "core/files.h"
#include "image/image.h"

namespace vct {

// Larger pictures are refused, on reading and on writing: their size in bytes no longer fits stb's int.
constexpr int maxImageSide = 16384;

enum class ImageFormat { png, exr };

// The format follows from the content. Throws vct::Error where it is neither of the two.
ImageFormat imageFormat(const std::string& path, const Bytes& bytes);

// Throws vct::Error where a side is 0 or above maxImageSide, or where the pixels are not width x height.
void checkWritable(const std::string& path, const Image& image);

// Throws PictureError where there is no memory for a picture in linear RGB, and for so many bytes besides.
void requirePixelMemory(int width, int height, std::size_t besides);

Image decodePng(const std::string& path, const Bytes& bytes);
Image decodeExr(const std::string& path, const Bytes& bytes);

}  // namespace vct
