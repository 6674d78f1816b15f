#include "render/gather.h"

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

Gather::Gather(const gl::ShaderLibrary& shaders, const GatherSettings& settings, GatherOf of,
               glm::ivec2 pictureSize)
    : trace_(shaders, gatherProgram(settings, of)), filter_(shaders, gatherFilterProgram(settings)) {
    const glm::ivec2 size = (pictureSize + settings.scale - 1) / settings.scale;
    // In 16 tiles side by side: shaders/shared/gather_surface.glsl.
    const glm::ivec2 tiled = (size + 3) / 4 * glm::ivec2(16, 1);
    raw_ = gl::Texture::make2d("gathered light", GL_RGBA16F, tiled.x, tiled.y);
    surface_ = gl::Texture::make2d("gathering surfaces", GL_RGBA16F, tiled.x, tiled.y);
    filtered_ = gl::Texture::make2d("filtered light", GL_RGBA16F, size.x, size.y);
    filteredSurface_ = gl::Texture::make2d("surfaces of filtered light", GL_RGBA16F, size.x, size.y);
    traceTarget_ = gl::Framebuffer("gather", {&raw_, &surface_}, nullptr);
    filterTarget_ = gl::Framebuffer("gather filter", {&filtered_, &filteredSurface_}, nullptr);
}

Gather::Targets Gather::draw(const GBuffer::Targets& surface, const FaceVoxels& voxels) {
    const gl::DebugGroup group("gather");
    gl::Disable(GL_DEPTH_TEST);
    gl::Disable(GL_CULL_FACE);
    noVertices_.bind();
    trace_.use();
    traceTarget_.bind();
    surface.normal->bind(VCT_TEX_G_NORMAL);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    voxels.faces().bind(VCT_TEX_FACES);
    gl::DrawArrays(GL_TRIANGLES, 0, 3);

    filter_.use();
    filterTarget_.bind();
    raw_.bind(VCT_TEX_GATHER);
    surface_.bind(VCT_TEX_GATHER_SURFACE);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    return {&filtered_, &filteredSurface_};
}

}  // namespace vct
