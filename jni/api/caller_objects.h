// Checks of textures and buffers of the embedding program. All throw vct::Error with cause and remedy.
#pragma once

#include <initializer_list>
#include <string>

#include "engine/deformer.h"
#include "vct/vct.h"

namespace vct {

// Throws if a texture of the caller's G-buffer has the wrong size or format.
void requireTarget(unsigned name, const char* what, glm::ivec2 size, std::initializer_list<GLint> formats);

// Throws if the buffer has not so many vertices.
ExternalVertices::Attribute attributeOf(unsigned buffer, std::size_t offset, std::size_t stride,
                                        std::size_t vertices, const char* member);

// Throws if a texture of the material is none. `name`: of the material.
void requireTextures(const MaterialDescription& material, const std::string& name);

}  // namespace vct
