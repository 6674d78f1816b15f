// The sun's shadow map (thesis 4.2), and its coarser levels for the soft shadow.
#pragma once

#include <optional>
#include <vector>

#include "engine/cascades.h"
#include "engine/gpu_scene.h"
#include "engine/output.h"
#include "engine/scene_state.h"
#include "engine/settings.h"
#include "engine/step_timer.h"
#include "gl/objects.h"
#include "shared/layout.h"

namespace vct {

gl::ProgramDescription shadowMapProgram(unsigned features);
gl::ProgramDescription shadowLevelProgram();

struct ShadowTextures {
    const gl::Texture* depth = nullptr;            // compare function LEQUAL, linear filter
    const gl::PlainSampler* plainDepth = nullptr;  // reads the finest level of `depth` without comparison

    // Binds the textures if they are not null.
    void bind() const;
};

class ShadowMap {
  public:
    // `size`: texels along a side. With more than one of `cascades`, there are 2 x 2 maps of that size.
    // `soft`: outputs with a soft shadow read coarser levels. The map has none until the first of them.
    ShadowMap(const gl::ShaderLibrary& shaders, const GpuScene& scene, int size, bool soft = false,
              int cascades = 1);

    // Draws the map if the state differs from the one that it was drawn for, or if `forceRebuild` is set.
    // Draws the coarser levels if `output` has a soft shadow.
    ShadowTextures update(const GpuScene& scene, const SceneState& now, const Cascades& cascades,
                          const shared::FrameUniforms& uniforms, Output output, bool forceRebuild,
                          StepTimer& timer);
    // Marks the map as out of date. Call it after a frame that failed.
    void invalidate() { cachedFor_.reset(); }

    const gl::Texture& texture() const { return depth_; }

  private:
    // Makes the texture and its framebuffers, which have to be drawn then.
    void makeTexture(int levels);
    void draw(const GpuScene& scene, const shared::FrameUniforms& uniforms);
    void drawTile(const GpuScene& scene, const DrawRegion& region, int tile);
    // Draws the tiles whose cascades are not at cascades_, and those that show a part of the `changed` boxes.
    void updateTiles(const GpuScene& scene, const shared::FrameUniforms& uniforms, const Cascades& cascades,
                     const std::vector<Bounds>& changed);
    void drawLevels();

    gl::ShaderLibrary shaders_;
    int size_, tiles_;
    bool soft_;
    MaterialPrograms programs_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
    std::vector<gl::Framebuffer> levels_;  // the coarser ones
    std::optional<gl::Program> levelProgram_;
    gl::PlainSampler plainDepth_;
    gl::VertexArray noVertices_;
    std::optional<SceneState> cachedFor_;  // the state that the map was drawn for, if it is valid
    std::optional<Cascades> cascades_;     // their places then
    bool levelsAreDrawn_ = false;
};

}  // namespace vct
