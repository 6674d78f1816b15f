#include "engine/passes/shade.h"

#include "engine/programs.h"
#include "gl/debug.h"
#include "shared/layout.h"

namespace vct {

Shade::Shade(gl::ShaderLibrary shaders, const Settings& settings)
    : shaders_(std::move(shaders)),
      settings_(settings),
      radiance_(gl::Texture::make2d("radiance", GL_RGBA16F, settings.size.x, settings.size.y)),
      framebuffer_("radiance", {&radiance_}, nullptr) {}

const gl::Program& Shade::program(int mode, const GBuffer::Targets& surface) {
    const ExtraTargets targets{surface.emissive != nullptr, surface.gloss != nullptr};
    const auto key = std::make_tuple(mode, targets.emissive, targets.gloss);
    auto found = programs_.find(key);
    if (found == programs_.end())
        found = programs_.emplace(key, gl::Program(shaders_, shadeProgram(mode, targets, settings_))).first;
    return found->second;
}

const gl::Texture& Shade::draw(int mode, const GBuffer::Targets& surface, const gl::Texture* shadowMap,
                               const Light& light) {
    const gl::DebugGroup group("cone trace");
    program(mode, surface).use();
    framebuffer_.bind();
    gl::Disable(GL_DEPTH_TEST);
    gl::Disable(GL_CULL_FACE);
    surface.albedo->bind(VCT_TEX_G_ALBEDO);
    surface.normal->bind(VCT_TEX_G_NORMAL);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    if (surface.emissive != nullptr) surface.emissive->bind(VCT_TEX_G_EMISSIVE);
    if (surface.gloss != nullptr) surface.gloss->bind(VCT_TEX_G_GLOSS);
    if (shadowMap != nullptr) {
        shadowMap->bind(VCT_TEX_SHADOW_MAP);
        shadowMap->bind(VCT_TEX_SHADOW_DEPTH);
        plainDepth_.bind(VCT_TEX_SHADOW_DEPTH);
    }
    if (light.voxels != nullptr) light.voxels->bind(VCT_TEX_VOXELS);
    if (light.irradiance != nullptr) {
        light.irradiance->bind(VCT_TEX_IRRADIANCE);
        light.bricks->bind(VCT_TEX_BRICKS);
    }
    if (light.faces != nullptr) light.faces->bind(VCT_TEX_FACES);
    noVertices_.bind();
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    return radiance_;
}

}  // namespace vct
