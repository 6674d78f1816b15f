// The last pass: computes the light of each pixel, or the part of it that an output shows (thesis 4.6).
#pragma once

#include <map>
#include <optional>
#include <tuple>

#include "engine/output.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/gloss.h"
#include "engine/passes/shadow_map.h"
#include "engine/programs.h"
#include "engine/voxel_volume.h"
#include "gl/program.h"

namespace vct {

gl::ProgramDescription shadeProgram(Output output, ExtraTargets targets, const LightFeatures& lights,
                                    const Settings& settings);

class Shade {
  public:
    Shade(gl::ShaderLibrary shaders, const LightFeatures& lights, const Settings& settings);

    // Textures that the output does not read may be null. Returns texture(): RGBA16F, rgb relative to E/pi,
    // a = 1 on surfaces, 0 on the sky.
    const gl::Texture& draw(Output output, const GBuffer::Targets& surface, const DirectLight& direct,
                            const VoxelLight& indirect);

    // Recreates the texture in another size, in pixels. The programs are kept.
    void resize(glm::ivec2 size);
    // From now on punctual lights may have a size of their own.
    void useSoftLights();
    const gl::Texture& texture() const { return radiance_; }
    Resources resources() const;

  private:
    const gl::Program& program(Output output, const GBuffer::Targets& surface);

    gl::ShaderLibrary shaders_;
    LightFeatures lights_;
    Settings settings_;
    std::map<std::tuple<Output, bool, bool, bool>, gl::Program> programs_;  // compiled on first use
    std::optional<Gloss> gloss_;  // if an output shows reflections, and a surface is glossy
    gl::Texture radiance_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_;
};

}  // namespace vct
