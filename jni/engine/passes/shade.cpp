#include "engine/passes/shade.h"

#include "gl/debug.h"
#include "gl/render_pass.h"
#include "shared/layout.h"

namespace vct {

gl::ProgramDescription shadeProgram(Picture mode, ExtraTargets targets, const LightSources& sources,
                                    const Settings& settings) {
    std::vector<std::string> defines{"VCT_MODE " + std::to_string(mode)};
    if (targets.emissive) defines.emplace_back("VCT_EMISSIVE_TARGET");
    if (targets.mappedNormals) defines.emplace_back("VCT_MAPPED_NORMALS");
    const bool reflects = mode == VCT_MODE_GI || mode == VCT_MODE_GI_CONE_SHADOW || mode == VCT_VIEW_SPECULAR;
    if (targets.gloss && reflects) defines.emplace_back("VCT_GLOSS_TARGET");
    if (sources.punctual && mode <= VCT_MODE_GI_CONE_SHADOW) defines.emplace_back("VCT_PUNCTUAL_LIGHTS");
    if (sources.punctual && mode == VCT_MODE_GI_CONE_SHADOW && settings.lightRadius > 0.0F)
        defines.emplace_back("VCT_SOFT_LIGHTS");
    const bool softShadow = mode == VCT_MODE_GI_CONE_SHADOW || mode == VCT_VIEW_CONE_SHADOW;
    if (softShadow && settings.shadow == Shadow::softMap) {
        defines.emplace_back("VCT_SOFT_SHADOW");
        defines.push_back("VCT_FILTER_TAPS " + std::to_string(settings.filterTaps));
    }
    // Only reflections meet lamps here: what faces received has their light already.
    for (const std::string& define :
         sourceDefines({false, sources.environment, sources.emitters && targets.gloss && reflects}))
        defines.push_back(define);
    const bool gathers = mode >= VCT_MODE_AO && mode != VCT_VIEW_CONE_SHADOW;
    if (gathers && settings.voxels == Voxels::directional) defines.emplace_back("VCT_RECEIVED");
    if (targets.gloss && reflects)
        for (const std::string& define : gatherDefines(settings.gather))
            defines.push_back(define);
    return {"shade " + std::to_string(mode), {"passes/full_screen.vert", "passes/shade.frag"}, defines};
}

Shade::Shade(gl::ShaderLibrary shaders, const LightSources& sources, const Settings& settings)
    : shaders_(std::move(shaders)), sources_(sources), settings_(settings) {
    resize(settings.size);
}

void Shade::resize(glm::ivec2 size) {
    radiance_ = gl::Texture::make2d("radiance", GL_RGBA16F, size.x, size.y);
    framebuffer_ = gl::Framebuffer("radiance", {&radiance_}, nullptr);
}

const gl::Program& Shade::program(Picture picture, const GBuffer::Targets& surface) {
    const ExtraTargets targets{surface.emissive != nullptr, surface.gloss != nullptr, surface.mappedNormals};
    const auto key = std::make_tuple(picture, targets.emissive, targets.gloss, targets.mappedNormals);
    auto found = programs_.find(key);
    if (found == programs_.end())
        found =
            programs_.emplace(key, gl::Program(shaders_, shadeProgram(picture, targets, sources_, settings_)))
                .first;
    return found->second;
}

const gl::Texture& Shade::draw(Picture picture, const GBuffer::Targets& surface, const DirectLight& direct,
                               const VoxelLight& indirect) {
    const gl::DebugGroup group("cone trace");
    program(picture, surface).use();
    const gl::RenderPass pass(framebuffer_, gl::Load::invalidate);
    surface.albedo->bind(VCT_TEX_G_ALBEDO);
    surface.normal->bind(VCT_TEX_G_NORMAL);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    if (surface.emissive != nullptr) surface.emissive->bind(VCT_TEX_G_EMISSIVE);
    if (surface.gloss != nullptr) surface.gloss->bind(VCT_TEX_G_GLOSS);
    direct.bind();
    if (indirect.packed != nullptr) indirect.packed->bind(VCT_TEX_VOXELS);
    if (indirect.irradiance != nullptr) {
        indirect.irradiance->bind(VCT_TEX_IRRADIANCE);
        indirect.bricks->bind(VCT_TEX_BRICKS);
    }
    if (indirect.faces != nullptr) indirect.faces->bind(VCT_TEX_FACES);
    noVertices_.bind();
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    return radiance_;
}

}  // namespace vct
