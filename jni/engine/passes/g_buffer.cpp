#include "engine/passes/g_buffer.h"

#include <algorithm>

#include "engine/programs.h"
#include "gl/api.h"
#include "gl/debug.h"
#include "gl/render_pass.h"
#include "gl/version.h"

namespace vct {

ExtraTargets extraTargets(const SceneFeatures& features, Voxels voxels) {
    return {features.has(featureEmissive) || features.has(featureUnlit),
            voxels == Voxels::directional && features.glossy, features.has(featureNormalMap),
            !features.has(featureUnlit) && !features.has(featureEmissiveTexture)};
}

gl::ProgramDescription gBufferProgram(unsigned features, ExtraTargets targets) {
    unsigned used = holeFeatures;
    if (targets.mappedNormals) used |= featureNormalMap;
    if (targets.emissive) used |= featureEmissive | featureEmissiveTexture | featureUnlit;
    if (targets.gloss) used |= featureGlossTexture;
    std::vector<std::string> defines = featureDefines(features, used);
    if (targets.mappedNormals) defines.emplace_back("VCT_MAPPED_NORMALS");
    if (targets.emissive) defines.emplace_back("VCT_EMISSIVE_TARGET");
    if (targets.gloss) defines.emplace_back(targets.emissive ? "VCT_GLOSS_TARGET 3" : "VCT_GLOSS_TARGET 2");
    return {"g_buffer", {"passes/g_buffer.vert", "passes/g_buffer.frag"}, defines};
}

namespace {

// The format of the target of emission. Not all drivers draw into packed floats.
GLenum emissionFormat(bool isPlain) {
    const std::vector<std::string> names = gl::extensionNames();
    const bool hasPackedFloats =
        gl::parseVersion(gl::glString(GL_VERSION)).atLeast(3, 2, 3, 0) ||
        std::find(names.begin(), names.end(), "GL_EXT_color_buffer_float") != names.end();
    return isPlain && hasPackedFloats ? GL_R11F_G11F_B10F : GL_RGBA16F;
}

}  // namespace

GBuffer::GBuffer(const gl::ShaderLibrary& shaders, const GpuScene& scene, glm::ivec2 size,
                 ExtraTargets targets)
    : programs_(shaders, scene, [targets](unsigned features) { return gBufferProgram(features, targets); }),
      extra_(targets) {
    resize(size);
}

void GBuffer::resize(glm::ivec2 size) {
    albedo_ = gl::Texture::make2d("G-buffer albedo", GL_RGBA8, size.x, size.y);
    normal_ = gl::Texture::make2d("G-buffer normal", extra_.mappedNormals ? GL_RGBA16UI : GL_RG16UI, size.x,
                                  size.y);
    depth_ = gl::Texture::make2d("G-buffer depth", GL_DEPTH_COMPONENT32F, size.x, size.y);
    std::vector<const gl::Texture*> colors{&albedo_, &normal_};
    if (extra_.emissive)
        colors.push_back(&emissive_.emplace(
            gl::Texture::make2d("G-buffer emissive", emissionFormat(extra_.isPlain), size.x, size.y)));
    if (extra_.gloss)
        colors.push_back(&gloss_.emplace(gl::Texture::make2d("G-buffer gloss", GL_RG8, size.x, size.y)));
    framebuffer_ = gl::Framebuffer("G-buffer", colors, &depth_);
}

GBuffer::Targets GBuffer::draw(const GpuScene& scene, const glm::mat4& clipFromVolume) {
    const gl::DebugGroup group("G-buffer");
    const gl::RenderPass pass(framebuffer_);
    scene.draw(GpuScene::Culling::backFaces, programs_, DrawRegion::inClipSpace(clipFromVolume));
    return targets();
}

GBuffer::Targets GBuffer::targets() const {
    return {&albedo_,
            &normal_,
            emissive_ ? &*emissive_ : nullptr,
            gloss_ ? &*gloss_ : nullptr,
            &depth_,
            extra_.mappedNormals};
}

Resources GBuffer::resources() const {
    Resources resources;
    for (const gl::Texture* target : {&albedo_, &normal_, targets().emissive, targets().gloss, &depth_})
        if (target != nullptr) add(resources, *target);
    return resources;
}

}  // namespace vct
