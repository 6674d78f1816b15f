// Uploads a scene's texture to the GPU.
#pragma once

#include "gl/objects.h"
#include "scene/scene.h"

namespace vct {

enum class TextureOf { colors, numbers };

// Returns SRGB8_ALPHA8 for colours, RGBA8 for numbers, with all mip levels. Filter and wrap modes are those
// that `source` names.
gl::Texture materialTexture(const Texture& source, TextureOf of = TextureOf::colors);

}  // namespace vct
