// The source of the look-up (shaders/directional/look_up.glsl) as a part of a program's own shaders.
#pragma once

#include <string>
#include <vector>

#include "gl/shader_source.h"

namespace vct {

// Assembles a file of shaders/ so that it can stand in a shader of another author: without comments, and
// with the prefix vct_ before all names that it declares except for `function`. `defines` are those of the
// file; no macro remains defined after the text.
std::string embeddableGlsl(const gl::ReadShader& read, const std::string& path,
                           const std::vector<std::string>& defines, const std::string& function);

}  // namespace vct
