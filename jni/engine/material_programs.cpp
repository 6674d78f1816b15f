#include "engine/material_programs.h"

#include <algorithm>
#include <tuple>

#include "engine/gpu_scene.h"

namespace vct {

MaterialPrograms::MaterialPrograms(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                                   const std::function<gl::ProgramDescription(unsigned features)>& describe) {
    std::vector<gl::ProgramDescription> known;
    for (const unsigned features : scene.features().materialFeatures) {
        const gl::ProgramDescription wanted = describe(features);
        const auto found = std::find_if(known.begin(), known.end(), [&](const gl::ProgramDescription& one) {
            return std::tie(one.shaders, one.defines) == std::tie(wanted.shaders, wanted.defines);
        });
        indices_[features] = static_cast<std::size_t>(found - known.begin());
        if (found != known.end()) continue;
        const auto reads = [&](const char* texture) {
            return std::count(wanted.defines.begin(), wanted.defines.end(), texture) > 0;
        };
        variants_.push_back({gl::Program(shaders, wanted), reads("VCT_BASE_COLOR_TEXTURE"),
                             reads("VCT_EMISSIVE_TEXTURE"), reads("VCT_GLOSS_TEXTURE"),
                             reads("VCT_NORMAL_MAP")});
        known.push_back(wanted);
    }
}

void MaterialPrograms::setUniform(GLint location, GLuint value) const {
    for (const Variant& variant : variants_) {
        variant.program.use();
        gl::Uniform1ui(location, value);
    }
}

}  // namespace vct
