#include "engine/passes/shade.h"

#include "gl/debug.h"
#include "gl/render_pass.h"

namespace vct {

gl::ProgramDescription shadeProgram(Output output, ExtraTargets targets, const LightFeatures& lights,
                                    const Settings& settings) {
    const OutputReads& read = reads(output);
    const std::string number = std::to_string(static_cast<int>(output));
    const bool directional = settings.voxels == Voxels::directional;
    // The modes 1 to 3 are the thesis's with all voxels.
    const bool isThesis = !directional || output <= Output::ao;
    std::vector<std::string> defines{"VCT_MODE " + number,
                                     booleanDefine("VCT_SHOWS_HARD_SHADOW", read.hardShadow),
                                     booleanDefine("VCT_SHOWS_SOFT_SHADOW", read.softShadow),
                                     booleanDefine("VCT_SHOWS_AMBIENT_VISIBILITY", read.ambientVisibility),
                                     booleanDefine("VCT_SHOWS_INDIRECT_LIGHT", read.indirectLight)};
    if (isThesis && directional) defines.emplace_back("VCT_DIRECTIONAL_VOXELS");
    const auto append = [&](const std::vector<std::string>& more) {
        defines.insert(defines.end(), more.begin(), more.end());
    };
    if (targets.emissive && read.emission) defines.emplace_back("VCT_EMISSIVE_TARGET");
    if (targets.mappedNormals) defines.emplace_back("VCT_MAPPED_NORMALS");
    const bool reflects = targets.gloss && read.reflections;
    if (reflects) defines.emplace_back("VCT_GLOSS_TARGET");
    const bool punctual = lights.punctual && read.punctualLights;
    if (punctual) defines.emplace_back("VCT_PUNCTUAL_LIGHTS");
    if (punctual && read.softShadow && (settings.lightRadius > 0.0F || lights.softPunctual))
        defines.emplace_back("VCT_SOFT_LIGHTS");
    append(lightDefines({false, lights.environment, false}));  // face irradiance includes emitters
    const char* const shader = isThesis ? "packed/shade.frag" : "passes/shade.frag";
    return {"shade " + number, {"passes/full_screen.vert", shader}, defines};
}

Shade::Shade(gl::ShaderLibrary shaders, const LightFeatures& lights, const Settings& settings)
    : shaders_(std::move(shaders)), lights_(lights), settings_(settings) {
    resize(settings.size);
}

void Shade::resize(glm::ivec2 size) {
    radiance_ = gl::Texture::make2d("radiance", GL_RGBA16F, size.x, size.y);
    framebuffer_ = gl::Framebuffer("radiance", {&radiance_}, nullptr);
    if (gloss_) gloss_->resize(radiance_);
}

void Shade::useSoftLights() {
    if (!std::exchange(lights_.softPunctual, true)) programs_.clear();
}

const gl::Program& Shade::program(Output output, const GBuffer::Targets& surface) {
    const ExtraTargets targets{surface.emissive != nullptr, surface.gloss != nullptr, surface.mappedNormals};
    const auto key = std::make_tuple(output, targets.emissive, targets.gloss, targets.mappedNormals);
    auto found = programs_.find(key);
    if (found == programs_.end())
        found =
            programs_.emplace(key, gl::Program(shaders_, shadeProgram(output, targets, lights_, settings_)))
                .first;
    return found->second;
}

const gl::Texture& Shade::draw(Output output, const GBuffer::Targets& surface, const DirectLight& direct,
                               const VoxelLight& indirect) {
    const gl::DebugGroup group("shade");
    const bool reflects = surface.gloss != nullptr && reads(output).reflections;
    if (reflects && !gloss_) gloss_.emplace(shaders_, lights_, radiance_);
    if (reflects) gloss_->traceRough(surface, indirect);
    program(output, surface).use();
    const gl::RenderPass pass(reflects ? gloss_->framebuffer() : framebuffer_, gl::Load::invalidate,
                              gl::Store::colors);
    if (reflects) gl::DepthFunc(GL_ALWAYS);
    surface.albedo->bind(VCT_TEX_G_ALBEDO);
    surface.normal->bind(VCT_TEX_G_NORMAL);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    if (surface.emissive != nullptr) surface.emissive->bind(VCT_TEX_G_EMISSIVE);
    if (surface.gloss != nullptr) surface.gloss->bind(VCT_TEX_G_GLOSS);
    direct.bind();
    if (indirect.packed != nullptr) indirect.packed->bind(VCT_TEX_VOXELS);
    if (indirect.bricks != nullptr) {
        indirect.bricks->bind(VCT_TEX_BRICKS);
        indirect.brickPlaces->bind(VCT_TEX_BRICK_PLACES);
        indirect.walls->bind(VCT_TEX_WALLS);
    }
    noVertices_.bind();
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    if (reflects) gloss_->add(surface, indirect);
    return radiance_;
}

Resources Shade::resources() const {
    Resources resources;
    add(resources, radiance_);
    if (gloss_) add(resources, gloss_->resources());
    return resources;
}

}  // namespace vct
