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

gl::ProgramDescription shadowLevelProgram() {
    return {"shadow_level", {"passes/full_screen.vert", "passes/shadow_level.frag"}, {}};
}

namespace {

// Number of levels of a map for soft shadows. The coarsest one has at least 16 texels along a side, and each
// has half as many as the finer one, so that no level mixes the tiles of cascades.
int levelsOf(int mapSize) {
    int levels = 1;
    while (mapSize % 2 == 0 && mapSize >= 32) {
        mapSize /= 2;
        ++levels;
    }
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
}

ShadowMap::ShadowMap(const gl::ShaderLibrary& shaders, const GpuScene& scene, int size, bool soft,
                     int cascades)
    : shaders_(shaders),
      size_(size),
      tiles_(cascades > 1 ? 2 : 1),
      soft_(soft),
      programs_(shaders, scene, shadowMapProgram) {
    makeTexture(1);
}

void ShadowMap::makeTexture(int levels) {
    cachedFor_.reset();
    // 16 bits are enough for the soft shadow, which tolerates their rounding (depthRounding in
    // shaders/shared/shadow.glsl). To the hard one they would add an error besides the thesis's bias.
    depth_ = {};
    depth_ = gl::Texture::make2d("shadow map", soft_ ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT24,
                                 tiles_ * size_, tiles_ * size_, levels);
    framebuffer_ = gl::Framebuffer("shadow map", {}, &depth_);
    // With a comparison, the linear filter averages comparisons of four texels of each level.
    depth_.setFilter(levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR, GL_LINEAR);
    depth_.setParameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    depth_.setParameter(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    for (int level = 1; level < levels; ++level)
        levels_.emplace_back("shadow map, level " + std::to_string(level), std::vector<const gl::Texture*>{},
                             &depth_, level);
}

ShadowTextures ShadowMap::update(const GpuScene& scene, const SceneState& now, const Cascades& cascades,
                                 const shared::FrameUniforms& uniforms, Output output, bool forceRebuild,
                                 StepTimer& timer) {
    if (soft_ && reads(output).softShadow && depth_.levels() < levelsOf(size_)) makeTexture(levelsOf(size_));
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
        levelsAreDrawn_ = false;
        cachedFor_ = now;
        cascades_ = cascades;
    }
    if (reads(output).softShadow && !levels_.empty() && !std::exchange(levelsAreDrawn_, true))
        timer.time(Step::shadowMap, [&] { drawLevels(); });
    return {&depth_, &plainDepth_};
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

void ShadowMap::drawLevels() {
    const gl::DebugGroup group("shadow map, coarser levels");
    if (!levelProgram_) levelProgram_.emplace(shaders_, shadowLevelProgram());
    depth_.bind(VCT_TEX_SHADOW_DEPTH);
    plainDepth_.bind(VCT_TEX_SHADOW_DEPTH);
    noVertices_.bind();
    levelProgram_->use();
    for (int level = 1; level < depth_.levels(); ++level) {
        // The shader may sample only the level below the one that is drawn to.
        for (const GLenum limit : {GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL})
            depth_.setParameter(limit, level - 1);
        gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
        const gl::RenderPass pass(levels_[static_cast<std::size_t>(level - 1)]);
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
    }
    depth_.setParameter(GL_TEXTURE_BASE_LEVEL, 0);
    depth_.setParameter(GL_TEXTURE_MAX_LEVEL, depth_.levels() - 1);
}

}  // namespace vct
