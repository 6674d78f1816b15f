// Every pixel's cones through the voxels, and the five modes (thesis 4.6).
#pragma once

#include <map>
#include <tuple>

#include "engine/passes/g_buffer.h"
#include "engine/passes/shadow_map.h"
#include "engine/programs.h"
#include "engine/voxel_volume.h"
#include "gl/program.h"

namespace vct {

gl::ProgramDescription shadeProgram(Picture picture, ExtraTargets targets, const LightSources& sources,
                                    const Settings& settings);

class Shade {
  public:
    Shade(gl::ShaderLibrary shaders, const LightSources& sources, const Settings& settings);

    // What a picture does not use may be null. Returns RGBA16F: rgb relative to E/pi, a 1 on surfaces.
    const gl::Texture& draw(Picture picture, const GBuffer::Targets& surface, const DirectLight& direct,
                            const VoxelLight& indirect);

    // Makes the texture anew; the programs stay.
    void resize(glm::ivec2 size);
    const gl::Texture& texture() const { return radiance_; }

  private:
    const gl::Program& program(Picture picture, const GBuffer::Targets& surface);

    gl::ShaderLibrary shaders_;
    LightSources sources_;
    Settings settings_;
    std::map<std::tuple<int, bool, bool, bool>, gl::Program> programs_;  // compiled when first asked for
    gl::Texture radiance_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_;
};

}  // namespace vct
