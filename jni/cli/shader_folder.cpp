#include "cli/shader_folder.h"

#include <cstdlib>

namespace vct::cli {

std::string shaderFolder() {
    const char* folder = std::getenv("VCT_SHADER_DIR");
    return folder != nullptr ? folder : VCT_DEFAULT_SHADER_DIR;
}

}  // namespace vct::cli
