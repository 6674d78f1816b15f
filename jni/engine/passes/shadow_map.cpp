#include "engine/passes/shadow_map.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <utility>

#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/render_pass.h"
#include "shared/layout.h"

namespace vct {

gl::ProgramDescription shadowMapProgram(unsigned features) {
    // The texture of an opaque surface does not affect its shadow.
    if (!(features & featureAlphaMask)) features = 0;
    return {"shadow_map",
            {"passes/shadow_map.vert", "passes/shadow_map.frag"},
            featureDefines(features, holeFeatures)};
}

gl::ProgramDescription shadowMomentsProgram() {
    return {"shadow_moments", {"passes/full_screen.vert", "passes/shadow_moments.frag"}, {}};
}

gl::ProgramDescription nextShadowMomentsProgram() {
    return {"shadow_moments_next", {"passes/full_screen.vert", "passes/shadow_moments_next.frag"}, {}};
}

namespace {

// Number of mip levels of the moments. The coarsest one has at least 16 texels along a side of a map.
int momentLevels(int mapSize) {
    int levels = 1;
    while (mapSize >> (levels + 1) >= 16)
        ++levels;
    return levels;
}

DrawRegion regionOfTile(const shared::FrameUniforms& uniforms, int tile) {
    const glm::dmat4 tileFromMap =
        glm::translate(glm::dmat4(1.0), glm::dvec3(-(tile & 1), -(tile >> 1), 0.0)) *
        glm::scale(glm::dmat4(1.0), glm::dvec3(2.0, 2.0, 1.0));
    return DrawRegion(tileFromMap * glm::dmat4(uniforms.shadowTileFromVolume[tile]));
}

}  // namespace

void ShadowTextures::bind() const {
    if (depth != nullptr) {
        depth->bind(VCT_TEX_SHADOW_MAP);
        depth->bind(VCT_TEX_SHADOW_DEPTH);
        plainDepth->bind(VCT_TEX_SHADOW_DEPTH);
    }
    if (moments != nullptr) moments->bind(VCT_TEX_SHADOW_MOMENTS);
}

ShadowMap::ShadowMap(const gl::ShaderLibrary& shaders, const GpuScene& scene, int size, bool soft,
                     int cascades)
    : shaders_(shaders),
      size_(size),
      tiles_(cascades > 1 ? 2 : 1),
      programs_(shaders, scene, shadowMapProgram),
      // 16 bits are enough for the soft shadow, which tolerates their rounding (depthRounding in
      // shaders/shared/shadow.glsl). To the hard one they would add an error besides the thesis's bias.
      depth_(gl::Texture::make2d("shadow map", soft ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT24,
                                 tiles_ * size, tiles_ * size)),
      framebuffer_("shadow map", {}, &depth_) {
    // With a comparison, the linear filter averages four comparisons.
    depth_.setFilter(GL_LINEAR, GL_LINEAR);
    depth_.setParameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    depth_.setParameter(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    if (!soft) return;
    moments_ = gl::Texture::make2d("shadow map's moments", GL_RG16F, std::max(tiles_ * size / 2, 1),
                                   std::max(tiles_ * size / 2, 1), momentLevels(size));
    moments_->setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    for (int level = 0; level < moments_->levels(); ++level)
        momentTargets_.emplace_back("shadow map's moments, level " + std::to_string(level),
                                    std::vector<const gl::Texture*>{&*moments_}, nullptr, level);
}

ShadowTextures ShadowMap::update(const GpuScene& scene, const SceneState& now, const Cascades& cascades,
                                 const shared::FrameUniforms& uniforms, Output output, bool forceRebuild,
                                 StepTimer& timer) {
    const bool isSameLight =
        !forceRebuild && cachedFor_ && cachedFor_->directionToLight == now.directionToLight;
    if (!isSameLight || cachedFor_->placements != now.placements || cascades_ != cascades) {
        const std::optional<SceneState> before = std::exchange(cachedFor_, {});
        timer.time(Step::shadowMap, [&] {
            if (isSameLight && tiles_ > 1)
                updateTiles(scene, uniforms, cascades, changedBoxes(before->placements, now.placements));
            else
                draw(scene, uniforms);
        });
        momentsAreDrawn_ = false;
        cachedFor_ = now;
        cascades_ = cascades;
    }
    if (reads(output).softShadow && moments_ && !std::exchange(momentsAreDrawn_, true))
        timer.time(Step::shadowMap, [&] { drawMoments(); });
    return {&depth_, moments(), &plainDepth_};
}

void ShadowMap::draw(const GpuScene& scene, const shared::FrameUniforms& uniforms) {
    const gl::DebugGroup group("shadow map");
    const gl::RenderPass pass(framebuffer_);
    // Single-sided surfaces cast shadows from both sides, as they do in a path tracer.
    if (tiles_ == 1) scene.draw(GpuScene::Culling::none, programs_, DrawRegion(uniforms.shadowFromVolume));
    for (int tile = 0; tiles_ > 1 && tile < VCT_SHADOW_TILES; ++tile)
        drawTile(scene, regionOfTile(uniforms, tile), tile);
}

void ShadowMap::drawTile(const GpuScene& scene, const DrawRegion& region, int tile) {
    programs_.setUniform(VCT_UNIFORM_SHADOW_TILE, static_cast<GLuint>(tile));
    gl::Viewport(size_ * (tile & 1), size_ * (tile >> 1), size_, size_);
    scene.draw(GpuScene::Culling::none, programs_, region);
}

void ShadowMap::updateTiles(const GpuScene& scene, const shared::FrameUniforms& uniforms,
                            const Cascades& cascades, const std::vector<Bounds>& changed) {
    const gl::DebugGroup group("shadow map, changed tiles");
    const gl::RenderPass pass(framebuffer_, gl::Load::keep);
    const GLfloat far = 1.0F;
    for (int tile = 0; tile < VCT_SHADOW_TILES; ++tile) {
        const int cascade = cascades.ofShadowTile(tile);
        const DrawRegion region = regionOfTile(uniforms, tile);
        if (cascades_->corner(cascade) == cascades.corner(cascade) && !region.meetsAny(changed)) continue;
        gl::Enable(GL_SCISSOR_TEST);
        gl::Scissor(size_ * (tile & 1), size_ * (tile >> 1), size_, size_);
        gl::ClearBufferfv(GL_DEPTH, 0, &far);
        gl::Disable(GL_SCISSOR_TEST);
        drawTile(scene, region, tile);
    }
}

void ShadowMap::drawMoments() {
    const gl::DebugGroup group("shadow map's moments");
    if (!nextMomentsProgram_) {
        momentsProgram_.emplace(shaders_, shadowMomentsProgram());
        nextMomentsProgram_.emplace(shaders_, nextShadowMomentsProgram());
    }
    depth_.bind(VCT_TEX_SHADOW_DEPTH);
    plainDepth_.bind(VCT_TEX_SHADOW_DEPTH);
    moments_->bind(VCT_TEX_SHADOW_MOMENTS);
    noVertices_.bind();
    momentsProgram_->use();
    for (int level = 0; level < moments_->levels(); ++level) {
        if (level == 1) nextMomentsProgram_->use();
        // The shader may sample only the level below the one that is drawn to.
        for (const GLenum limit : {GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL})
            moments_->setParameter(limit, std::max(level - 1, 0));
        const gl::RenderPass pass(momentTargets_[static_cast<std::size_t>(level)], gl::Load::invalidate);
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
    }
    moments_->setParameter(GL_TEXTURE_BASE_LEVEL, 0);
    moments_->setParameter(GL_TEXTURE_MAX_LEVEL, moments_->levels() - 1);
}

}  // namespace vct
