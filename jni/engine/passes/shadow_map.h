// Depth of the scene from the light (thesis 4.2).
#pragma once

#include <optional>
#include <vector>

#include "engine/gpu_scene.h"
#include "engine/picture.h"
#include "engine/scene_state.h"
#include "engine/settings.h"
#include "gl/objects.h"
#include "lab/step_timer.h"

namespace vct {

// Of its texture, for ShadowMap::makeLevels(): down to 16 texels a side, as wide as a hundredth of any scene.
int shadowMapLevels(const Settings& settings);

gl::ProgramDescription shadowMapProgram(unsigned features);
gl::ProgramDescription shadowLevelProgram();

class ShadowMap {
  public:
    // `levels`: those of the texture; draw() writes the finest, and makeLevels() the others.
    ShadowMap(const gl::ShaderLibrary& shaders, const GpuScene& scene, int size, int levels = 1);

    // Draws the map where pose or sun have changed since it was drawn, or where `remake` asks for it, and the
    // coarser levels where `picture` shows a soft shadow. Returns the texture as draw() does.
    const gl::Texture& update(const GpuScene& scene, const SceneState& now, Picture picture, bool remake,
                              StepTimer& timer);
    // What there is may be wrong, as a frame failed: the next update draws it anew.
    void forget() { drawn_.reset(); }

    // Returns the depth texture: compare function LEQUAL, hardware filter, ready to be sampled.
    const gl::Texture& draw(const GpuScene& scene);

    // For the soft shadow, whose comparisons are far apart where the penumbra is wide.
    // shaders/passes/shadow_level.frag.
    void makeLevels();

    const gl::Texture& texture() const { return depth_; }

  private:
    gl::ShaderLibrary shaders_;
    MaterialPrograms programs_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
    std::optional<gl::Program> levelProgram_;
    std::vector<gl::Framebuffer> coarser_;
    gl::PlainSampler plainDepth_;
    gl::VertexArray noVertices_;
    std::optional<SceneState> drawn_;  // of what the map is; nothing where it was not drawn
    bool levelsAreDrawn_ = false;
};

}  // namespace vct
