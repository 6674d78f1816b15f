#include "lab/debug_view.h"

#include <algorithm>
#include <utility>

#include "engine/directional/directional_volume.h"
#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/objects.h"
#include "gl/read_back.h"
#include "gl/render_pass.h"
#include "lab/voxel_view.h"

namespace vct {

namespace {

// Draws a view (VCT_DEBUG_VIEW_*) by lab/debug_view.frag. The caller binds the textures.
Image draw(const gl::ShaderLibrary& shaders, int view, glm::ivec2 size) {
    const gl::DebugGroup group("debug view");
    const gl::Program program(shaders, debugViewProgram(view));
    const gl::Texture color = gl::Texture::make2d("debug view", GL_RGBA16F, size.x, size.y);
    const gl::Framebuffer framebuffer("debug view", {&color}, nullptr);
    const gl::VertexArray noVertices;
    {
        const gl::RenderPass pass(framebuffer, gl::Load::invalidate);
        program.use();
        noVertices.bind();
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
    }
    return readImage(color);
}

// Stretches the depths below 1 to a wider range of grey values, because they lie close together. A depth of 1
// (no surface) stays white.
Image stretchDepth(Image depth) {
    float low = 1.0F;
    float high = 0.0F;
    for (const glm::vec3& p : depth.pixels)
        if (p.x < 1.0F) {
            low = std::min(low, p.x);
            high = std::max(high, p.x);
        }
    if (high > low)
        for (glm::vec3& p : depth.pixels)
            if (p.x < 1.0F) p = glm::vec3(0.8F * (p.x - low) / (high - low));
    return depth;
}

}  // namespace

gl::ProgramDescription debugViewProgram(int view) {
    return {"debug_view " + std::to_string(view),
            {"passes/full_screen.vert", "lab/debug_view.frag"},
            {"VCT_DEBUG_VIEW " + std::to_string(view)}};
}

std::vector<DebugView> lightParts(Renderer& renderer, const Camera& camera) {
    std::vector<DebugView> parts;
    const auto add = [&](Output output, bool allBounces) {
        renderer.render({{output}, camera, LightSteps::all, nullptr, allBounces});
        const bool isShare = output == Output::ambientVisibility || output == Output::sunVisibility;
        const float unit = isShare ? 1.0F : renderer.radianceScale();
        parts.push_back({outputName(output), readImage(renderer.output(), unit), true, isShare});
    };
    add(Output::ambientVisibility, true);
    add(Output::indirectLight, false);
    add(Output::sunVisibility, true);
    if (renderer.surface().gloss != nullptr) add(Output::specularLight, true);
    return parts;
}

std::vector<std::string> lightPartNames() {
    std::vector<std::string> names;
    for (const Output output :
         {Output::ambientVisibility, Output::indirectLight, Output::sunVisibility, Output::specularLight})
        names.emplace_back(outputName(output));
    return names;
}

std::vector<DebugView> debugViews(Renderer& renderer, const Camera& camera) {
    renderer.render({{Output::giConeShadow}, camera, LightSteps::all});
    const gl::ShaderLibrary& shaders = renderer.shaders();
    const glm::ivec2 size = renderer.settings().size;
    const GBuffer::Targets surface = renderer.surface();
    std::vector<DebugView> views;

    surface.albedo->bind(VCT_TEX_G_ALBEDO);
    surface.normal->bind(VCT_TEX_G_NORMAL);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    const gl::Texture& shadow = renderer.shadowMapTexture();
    shadow.bind(VCT_TEX_SHADOW_MAP);
    // Here the shadow map is read as a picture, without depth comparison.
    shadow.setParameter(GL_TEXTURE_COMPARE_MODE, GL_NONE);
    const glm::ivec2 shadowSize(renderer.settings().shadowMapSize);
    views.push_back(
        {"shadow_map", stretchDepth(draw(shaders, VCT_DEBUG_VIEW_SHADOW_MAP, shadowSize)), false});
    shadow.setParameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);

    views.push_back({"g_buffer_albedo", draw(shaders, VCT_DEBUG_VIEW_ALBEDO, size), true});
    views.push_back({"g_buffer_normal", draw(shaders, VCT_DEBUG_VIEW_NORMAL, size), false});
    views.push_back({"g_buffer_depth", stretchDepth(draw(shaders, VCT_DEBUG_VIEW_DEPTH, size)), false});
    if (surface.emissive != nullptr) {
        surface.emissive->bind(VCT_TEX_G_EMISSIVE);
        views.push_back({"g_buffer_emissive", draw(shaders, VCT_DEBUG_VIEW_EMISSIVE, size), false});
    }

    VoxelView voxelView(shaders, size);
    const VoxelPyramid& occupancy = renderer.occupancy();
    for (int level = 0; level < occupancy.levels(); ++level) {
        const DirectionalVolume* const directional = renderer.directional();
        const std::vector<std::uint32_t> list =
            directional != nullptr ? directional->voxels().readVoxels() : occupancy.readList(level);
        views.push_back({"voxels_level_" + std::to_string(level),
                         readImage(voxelView.draw(occupancy, level, list)), false});
    }

    for (DebugView& part : lightParts(renderer, camera))
        views.push_back(std::move(part));
    gl::checkErrors("debug views");
    return views;
}

}  // namespace vct
