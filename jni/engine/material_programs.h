// The programs of a pass that draws triangles: one for each combination of the material features it reads.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "gl/program.h"

namespace vct {

class GpuScene;

// Compiles the programs for all combinations of features in the scene. Combinations for which `describe`
// returns the same shaders and defines share a program.
class MaterialPrograms {
  public:
    MaterialPrograms(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                     const std::function<gl::ProgramDescription(unsigned features)>& describe);
    struct Variant {
        gl::Program program;
        bool readsBaseColorTexture, readsEmissiveTexture, readsGlossTexture, readsNormalMap;
    };
    // Sets the uniform at this location in all programs.
    void setUniform(GLint location, GLuint value) const;
    const Variant& operator()(unsigned features) const { return variants_[indices_.at(features)]; }

  private:
    std::vector<Variant> variants_;
    std::map<unsigned, std::size_t> indices_;  // by features
};

}  // namespace vct
