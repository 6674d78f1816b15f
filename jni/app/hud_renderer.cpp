#include "app/hud_renderer.h"

#include <cstddef>

#include "app/app_programs.h"
#include "gl/debug.h"

namespace vct::app {

namespace {

constexpr int fontUnit = 0;  // texture unit; 0 is a sampler's default

enum Attribute : GLuint { position = 0, uv = 1, color = 2 };  // locations in app/hud.vert

float fontSize() {
    return ImGui::GetIO().Fonts->Fonts[0]->FontSize;
}

gl::Texture fontTexture() {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    gl::Texture texture = gl::Texture::make2d("font", GL_RGBA8, width, height);
    texture.setFilter(GL_LINEAR, GL_LINEAR);
    texture.bind(fontUnit);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl::TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    return texture;
}

}  // namespace

HudRenderer::HudRenderer(const gl::ShaderLibrary& shaders)
    : program_(shaders, hudProgram()),
      windowUniform_(program_.uniform("window")),
      font_(fontTexture()),
      fontSize_(fontSize()) {
    vertexArray_.bind();
    vertices_ = gl::Buffer("panel vertices", GL_ARRAY_BUFFER, 0, nullptr, GL_STREAM_DRAW);
    indices_ = gl::Buffer("panel indices", GL_ELEMENT_ARRAY_BUFFER, 0, nullptr, GL_STREAM_DRAW);
    const auto attribute = [](Attribute location, GLint components, GLenum type, bool normalized,
                              std::size_t offset) {
        gl::EnableVertexAttribArray(location);
        gl::VertexAttribPointer(location, components, type, normalized ? GL_TRUE : GL_FALSE,
                                sizeof(ImDrawVert), reinterpret_cast<const void*>(offset));
    };
    attribute(position, 2, GL_FLOAT, false, offsetof(ImDrawVert, pos));
    attribute(uv, 2, GL_FLOAT, false, offsetof(ImDrawVert, uv));
    attribute(color, 4, GL_UNSIGNED_BYTE, true, offsetof(ImDrawVert, col));
}

void HudRenderer::draw(const ImDrawData& data, glm::ivec2 window) {
    const gl::DebugGroup group("panel");
    if (fontSize_ != fontSize()) {
        font_ = fontTexture();
        fontSize_ = fontSize();
    }
    gl::Enable(GL_BLEND);
    gl::BlendEquation(GL_FUNC_ADD);
    gl::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl::Enable(GL_SCISSOR_TEST);
    program_.use();
    gl::Uniform4f(windowUniform_, 2.0F / static_cast<float>(window.x), 2.0F / static_cast<float>(window.y),
                  0.0F, 0.0F);
    font_.bind(fontUnit);
    vertexArray_.bind();
    indices_.bind(GL_ELEMENT_ARRAY_BUFFER);  // a driver fault requires this: see GpuScene::bindGeometry()
    vertices_.bind(GL_ARRAY_BUFFER);
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        gl::BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
        gl::BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                       GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const glm::ivec2 low =
                glm::clamp(glm::ivec2(command.ClipRect.x, command.ClipRect.y), glm::ivec2(0), window);
            const glm::ivec2 high =
                glm::clamp(glm::ivec2(command.ClipRect.z, command.ClipRect.w), glm::ivec2(0), window);
            if (low.x >= high.x || low.y >= high.y) continue;
            gl::Scissor(low.x, window.y - high.y, high.x - low.x, high.y - low.y);
            gl::DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                             sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                             reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)));
        }
    }
    gl::Disable(GL_SCISSOR_TEST);
    gl::Disable(GL_BLEND);
}

}  // namespace vct::app
