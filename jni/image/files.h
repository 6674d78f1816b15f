// The two file formats behind readImage(). Private to jni/image and the compare command.
#pragma once

#include <string>

#include "core/files.h"
#include "image/image.h"

namespace vct {

// Larger pictures are refused, on reading and on writing, because their size in bytes does not fit stb's int.
constexpr int maxImageSide = 16384;

enum class ImageFormat { png, exr };

// Determines the format from the content. Throws vct::Error if it is neither of the two.
ImageFormat imageFormat(const std::string& path, const Bytes& bytes);

// Throws vct::Error if a side is 0 or above maxImageSide, or if the number of pixels is not width x height.
void checkWritable(const std::string& path, const Image& image);

// Throws PictureError if there is not enough memory for a picture in linear RGB and `besides` bytes.
void requirePixelMemory(int width, int height, std::size_t besides);

Image decodePng(const std::string& path, const Bytes& bytes);
Image decodeExr(const std::string& path, const Bytes& bytes);

}  // namespace vct
