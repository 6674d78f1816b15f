// A scene's texture on its way to the GPU.
#pragma once

#include "gl/objects.h"
#include "scene/scene.h"

namespace vct {

enum class TextureOf { colors, numbers };

// SRGB8_ALPHA8, or of numbers RGBA8, with all its mip levels, filtered and wrapped as `source` says.
gl::Texture materialTexture(const Texture& source, TextureOf of = TextureOf::colors);

}  // namespace vct
