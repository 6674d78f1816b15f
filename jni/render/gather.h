// The diffuse light and the occlusion of the visible surfaces, by cones through the directional coverage
// voxels, at a fraction of the picture's resolution.
#pragma once

#include "gl/program.h"
#include "render/face_voxels.h"
#include "render/g_buffer.h"
#include "render/settings.h"

namespace vct {

class Gather {
  public:
    Gather(const gl::ShaderLibrary& shaders, const GatherSettings& settings, GatherOf of,
           glm::ivec2 pictureSize);

    struct Targets {
        const gl::Texture* light;    // RGBA16F: radiance before albedo, relative to E/pi; openness
        const gl::Texture* surface;  // RGBA16F: shaders/shared/gather_surface.glsl
    };
    Targets draw(const GBuffer::Targets& surface, const FaceVoxels& voxels);

    std::vector<const gl::Texture*> textures() const {
        return {&raw_, &surface_, &filtered_, &filteredSurface_};
    }

  private:
    gl::Program trace_, filter_;
    gl::Texture raw_, surface_, filtered_, filteredSurface_;
    gl::Framebuffer traceTarget_, filterTarget_;
    gl::VertexArray noVertices_;
};

}  // namespace vct
