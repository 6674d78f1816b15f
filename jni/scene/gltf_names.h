// Lists parts of a glTF file that a Scene does not have, for people.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf.h"

namespace vct {

struct GltfNames {
    std::vector<std::string> animations;  // "1 (walk)"
    std::vector<std::string> variants;    // of KHR_materials_variants
};

// Reads the file again. Throws vct::Error as loadGltf() does.
GltfNames namesOfGltf(const std::string& path, const ReadFile& readFile, const GltfOptions& options);

}  // namespace vct
