#include "lab/debug_view.h"

#include <algorithm>

#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/objects.h"
#include "lab/read_back.h"

namespace vct {

Image drawDebugView(const gl::ShaderLibrary& shaders, int stage, glm::ivec2 size) {
    const gl::DebugGroup group("stage view");
    const gl::Program program(shaders, debugViewProgram(stage));
    const gl::Texture color = gl::Texture::make2d("stage view", GL_RGBA16F, size.x, size.y);
    const gl::Framebuffer framebuffer("stage view", {&color}, nullptr);
    const gl::VertexArray noVertices;
    framebuffer.bind();
    gl::Disable(GL_DEPTH_TEST);
    gl::Disable(GL_CULL_FACE);
    program.use();
    noVertices.bind();
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    return readImage(color);
}

Image stretchDepth(const Image& depth) {
    float low = 1.0F;
    float high = 0.0F;
    for (const glm::vec3& p : depth.pixels)
        if (p.x < 1.0F) {
            low = std::min(low, p.x);
            high = std::max(high, p.x);
        }
    Image stretched = depth;
    if (high > low)
        for (glm::vec3& p : stretched.pixels)
            if (p.x < 1.0F) p = glm::vec3(0.8F * (p.x - low) / (high - low));
    return stretched;
}

}  // namespace vct
