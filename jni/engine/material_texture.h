// Uploads a scene's texture to the GPU.
#pragma once

#include <optional>

#include "gl/objects.h"
#include "scene/scene.h"

namespace vct {

enum class TextureOf { colors, numbers };

// Returns SRGB8_ALPHA8 for colours, RGBA8 for numbers, with all mip levels. Filter and wrap modes are those
// that `source` names. `holesBelow`: the alpha below which a mask that reads the texture has a hole. Each mip
// level of a mask has holes of the same total area as level 0. The coarsest levels, which have too few texels
// for that, are left out.
gl::Texture materialTexture(const Texture& source, TextureOf of = TextureOf::colors,
                            std::optional<float> holesBelow = {});

}  // namespace vct
