// Every pixel's cones through the voxels, and the five modes (thesis 4.6).
#pragma once

#include <map>
#include <tuple>

#include "engine/passes/g_buffer.h"
#include "engine/settings.h"
#include "gl/program.h"

namespace vct {

class Shade {
  public:
    Shade(gl::ShaderLibrary shaders, const Settings& settings);

    // Where a mode's diffuse light comes from: cones through words here, or what the faces have received.
    struct Light {
        const gl::Texture* voxels = nullptr;
        const gl::Texture* irradiance = nullptr;
        const gl::Texture* bricks = nullptr;  // with it: shaders/directional/irradiance.glsl
        const gl::Texture* faces = nullptr;   // for the specular cones of a G-buffer with gloss
    };
    // `mode`: one of VCT_MODE_* and VCT_VIEW_*. What a mode does not use may be null. Returns RGBA16F: rgb
    // relative to E/pi, a 1 on surfaces.
    const gl::Texture& draw(int mode, const GBuffer::Targets& surface, const gl::Texture* shadowMap,
                            const Light& light);

    const gl::Texture& texture() const { return radiance_; }

  private:
    const gl::Program& program(int mode, const GBuffer::Targets& surface);

    gl::ShaderLibrary shaders_;
    Settings settings_;
    std::map<std::tuple<int, bool, bool>, gl::Program> programs_;  // compiled when first asked for
    gl::Texture radiance_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_;
    gl::PlainSampler plainDepth_;  // the shadow map for shared/shadow.glsl
};

}  // namespace vct
