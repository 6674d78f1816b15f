// A pass over the triangles has a program for each combination of material features that it tells apart.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "gl/program.h"

namespace vct {

class GpuScene;

// The programs of one pass, one for all material features that occur in the scene and that it does not tell
// apart.
class MaterialPrograms {
  public:
    MaterialPrograms(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                     const std::function<gl::ProgramDescription(unsigned features)>& describe);
    struct Variant {
        gl::Program program;
        bool readsBaseColorTexture, readsEmissiveTexture, readsGlossTexture, readsNormalMap;
    };
    // A uniform at the same location in all of them.
    void setUniform(GLint location, GLuint value) const;
    const Variant& operator()(unsigned features) const { return variants_[indices_.at(features)]; }

  private:
    std::vector<Variant> variants_;
    std::map<unsigned, std::size_t> indices_;  // by features
};

}  // namespace vct
