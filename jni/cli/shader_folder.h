// Where the program reads its shaders.
#pragma once

#include <string>

namespace vct::cli {

// VCT_SHADER_DIR from the environment, or the folder of the source tree that built the program.
std::string shaderFolder();

}  // namespace vct::cli
