#include "engine/passes/gloss.h"

#include "engine/directional/directional_voxels.h"
#include "gl/debug.h"
#include "gl/render_pass.h"

namespace vct {

namespace {

gl::ProgramDescription program(const char* name, const char* shader, bool mappedNormals,
                               const LightFeatures& lights) {
    std::vector<std::string> defines = lightDefines(lights);
    if (mappedNormals) defines.emplace_back("VCT_MAPPED_NORMALS");
    if (lights.punctual) defines.emplace_back("VCT_PUNCTUAL_LIGHTS");
    for (const std::string& define : emissionDefines(lights.emission))
        defines.push_back(define);
    return {name, {"passes/full_screen.vert", shader}, defines};
}

void bind(const GBuffer::Targets& surface, const VoxelLight& light) {
    surface.albedo->bind(VCT_TEX_G_ALBEDO);
    surface.normal->bind(VCT_TEX_G_NORMAL);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    surface.gloss->bind(VCT_TEX_G_GLOSS);
    light.directional->bindForRays();
    light.bricks->bind(VCT_TEX_BRICKS);
    light.brickPlaces->bind(VCT_TEX_BRICK_PLACES);
    light.walls->bind(VCT_TEX_WALLS);
}

// Draws the pixels whose depth is above 0.5, that of the triangle.
void drawMarked() {
    gl::DepthFunc(GL_LESS);
    gl::DepthMask(GL_FALSE);
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace

gl::ProgramDescription markGlossProgram() {
    return {"gloss, mark", {"passes/full_screen.vert", "passes/gloss_mark.frag"}, {}};
}

gl::ProgramDescription glossProgram(bool mappedNormals, const LightFeatures& lights) {
    return program("gloss", "passes/gloss.frag", mappedNormals, lights);
}

gl::ProgramDescription halfGlossProgram(bool mappedNormals, const LightFeatures& lights) {
    return program("gloss, half", "passes/gloss_half.frag", mappedNormals, lights);
}

gl::ProgramDescription filterGlossProgram(bool mappedNormals, const LightFeatures& lights) {
    return program("gloss, filter", "passes/gloss_filter.frag", mappedNormals, lights);
}

Gloss::Gloss(gl::ShaderLibrary shaders, const LightFeatures& lights, const gl::Texture& picture)
    : shaders_(std::move(shaders)), lights_(lights) {
    resize(picture);
}

void Gloss::resize(const gl::Texture& picture) {
    const int width = picture.width(), height = picture.height();
    half_ = gl::Texture::make2d("rough reflections", GL_RGBA16F, (width + 1) / 2, (height + 1) / 2);
    halfMask_ =
        gl::Texture::make2d("mask of rough reflections", GL_DEPTH_COMPONENT16, half_.width(), half_.height());
    halfFramebuffer_ = gl::Framebuffer("rough reflections", {&half_}, &halfMask_);
    filtered_ = gl::Texture::make2d("filtered reflections", GL_RGBA16F, half_.width(), half_.height());
    filteredFramebuffer_ = gl::Framebuffer("filtered reflections", {&filtered_}, nullptr);
    mask_ = gl::Texture::make2d("mask of reflections", GL_DEPTH_COMPONENT16, width, height);
    pictureAndMask_ = gl::Framebuffer("radiance and mask of reflections", {&picture}, &mask_);
}

const Gloss::Programs& Gloss::programs(bool mappedNormals) {
    auto found = programs_.find(mappedNormals);
    if (found == programs_.end())
        found = programs_
                    .emplace(mappedNormals,
                             Programs{gl::Program(shaders_, markGlossProgram()),
                                      gl::Program(shaders_, halfGlossProgram(mappedNormals, lights_)),
                                      gl::Program(shaders_, filterGlossProgram(mappedNormals, lights_)),
                                      gl::Program(shaders_, glossProgram(mappedNormals, lights_))})
                    .first;
    return found->second;
}

void Gloss::traceRough(const GBuffer::Targets& surface, const VoxelLight& light) {
    const gl::DebugGroup group("rough reflections");
    bind(surface, light);
    noVertices_.bind();
    const Programs& shaders = programs(surface.mappedNormals);
    {
        const gl::RenderPass pass(halfFramebuffer_, gl::Load::invalidate, gl::Store::colors);
        shaders.mark.use();
        gl::DepthFunc(GL_ALWAYS);
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
        shaders.half.use();
        drawMarked();
    }
    shaders.filter.use();
    for (const int axis : {0, 1}) {
        (axis == 0 ? half_ : filtered_).bind(VCT_TEX_HALF_GLOSS);
        const gl::RenderPass pass(axis == 0 ? filteredFramebuffer_ : halfFramebuffer_, gl::Load::invalidate,
                                  gl::Store::colors);
        gl::Uniform1ui(VCT_UNIFORM_AXIS, static_cast<GLuint>(axis));
        gl::DepthFunc(GL_ALWAYS);
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
    }
}

void Gloss::add(const GBuffer::Targets& surface, const VoxelLight& light) {
    const gl::DebugGroup group("reflections");
    programs(surface.mappedNormals).full.use();
    bind(surface, light);
    half_.bind(VCT_TEX_HALF_GLOSS);
    noVertices_.bind();
    gl::Enable(GL_BLEND);
    gl::BlendEquation(GL_FUNC_ADD);
    gl::BlendFunc(GL_ONE, GL_ONE);
    drawMarked();
    gl::Disable(GL_BLEND);
}

Resources Gloss::resources() const {
    Resources resources;
    for (const gl::Texture* target : {&half_, &filtered_, &halfMask_, &mask_})
        vct::add(resources, *target);
    return resources;
}

}  // namespace vct
