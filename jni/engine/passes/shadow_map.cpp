#include "engine/passes/shadow_map.h"

#include <utility>

#include "engine/programs.h"
#include "gl/debug.h"
#include "shared/layout.h"

namespace vct {

gl::ProgramDescription shadowMapProgram(unsigned features) {
    // An opaque surface's texture does not matter to its shadow.
    if (!(features & featureAlphaMask)) features = 0;
    return {"shadow_map",
            {"passes/shadow_map.vert", "passes/shadow_map.frag"},
            featureDefines(features, featureBaseColorTexture | featureAlphaMask)};
}

gl::ProgramDescription shadowLevelProgram() {
    return {"shadow_level", {"passes/full_screen.vert", "passes/shadow_level.frag"}, {}};
}

int shadowMapLevels(const Settings& settings) {
    if (settings.shadow != Shadow::softMap) return 1;
    int levels = 1;
    while (settings.shadowMapSize >> levels >= 16)
        ++levels;
    return levels;
}

ShadowMap::ShadowMap(const gl::ShaderLibrary& shaders, const GpuScene& scene, int size, int levels)
    : shaders_(shaders),
      programs_(shaders, scene, shadowMapProgram),
      // A texel of a map is 16 times as wide as a step of 16 bits; the thesis's bias is left as it was.
      depth_(gl::Texture::make2d("shadow map", levels > 1 ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT24, size,
                                 size, levels)),
      framebuffer_("shadow map", {}, &depth_) {
    // With a comparison: four taps of a level, weighted.
    depth_.setFilter(levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR, GL_LINEAR);
    depth_.setParameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    depth_.setParameter(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

const gl::Texture& ShadowMap::update(const GpuScene& scene, const SceneState& now, Picture picture,
                                     bool remake, StepTimer& timer) {
    if (remake || drawn_ != now) {
        drawn_.reset();
        timer.time(Step::shadowMap, [&] { draw(scene); });
        levelsAreDrawn_ = false;
        drawn_ = now;
    }
    if (showsSoftShadow(picture) && depth_.levels() > 1 && !std::exchange(levelsAreDrawn_, true))
        timer.time(Step::shadowMap, [&] { makeLevels(); });
    return depth_;
}

const gl::Texture& ShadowMap::draw(const GpuScene& scene) {
    const gl::DebugGroup group("shadow map");
    framebuffer_.bind();
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_LESS);
    gl::DepthMask(GL_TRUE);
    const float far = 1.0F;
    gl::ClearBufferfv(GL_DEPTH, 0, &far);
    // Single-sided surfaces cast shadows from both sides, as they do in a path tracer.
    scene.draw(GpuScene::Culling::none, programs_);
    return depth_;
}

void ShadowMap::makeLevels() {
    const gl::DebugGroup group("shadow map's levels");
    if (!levelProgram_) levelProgram_.emplace(shaders_, shadowLevelProgram());
    for (int level = static_cast<int>(coarser_.size()) + 1; level < depth_.levels(); ++level)
        coarser_.emplace_back("shadow map's level " + std::to_string(level),
                              std::vector<const gl::Texture*>{}, &depth_, level);
    levelProgram_->use();
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_ALWAYS);
    gl::DepthMask(GL_TRUE);
    gl::Disable(GL_CULL_FACE);
    depth_.bind(VCT_TEX_SHADOW_DEPTH);
    plainDepth_.bind(VCT_TEX_SHADOW_DEPTH);
    // Only the finest is read: what is drawn to must be out of the shader's reach.
    depth_.setParameter(GL_TEXTURE_MAX_LEVEL, 0);
    noVertices_.bind();
    for (int level = 1; level < depth_.levels(); ++level) {
        coarser_[static_cast<std::size_t>(level) - 1].bind();
        gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
    }
    depth_.setParameter(GL_TEXTURE_MAX_LEVEL, depth_.levels() - 1);
}

}  // namespace vct
