// Saves and restores the GL state that the engine changes, as include/vct/vct.h promises.
#pragma once

#include <array>

#include "gl/api.h"
#include "shared/layout.h"

namespace vct {

// The constructor saves the state and sets the state that the engine's passes expect; the destructor restores
// it.
class SavedState {
  public:
    SavedState();
    ~SavedState();
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

  private:
    struct TextureUnit {
        GLint sampler = 0;
        std::array<GLint, 4> textures{};  // by target
    };
    struct IndexedBuffer {
        GLint buffer = 0;
        GLint64 start = 0, size = 0;
    };
    struct Image {
        GLint texture = 0, level = 0, layered = 0, layer = 0, access = 0, format = 0;
    };
    static constexpr std::array<GLenum, 9> switches{
        GL_BLEND,           GL_CULL_FACE,           GL_DEPTH_TEST,
        GL_SCISSOR_TEST,    GL_POLYGON_OFFSET_FILL, GL_RASTERIZER_DISCARD,
        GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK,         GL_SAMPLE_ALPHA_TO_COVERAGE};
    // Units 0 to the last one that passes read, and the one on which textures are created.
    static constexpr std::size_t textureUnits = VCT_TEX_DYNAMIC_PAGES + 2;

    std::array<GLint, switches.size()> enabled_{};
    GLint drawFramebuffer_ = 0, readFramebuffer_ = 0, program_ = 0, vertexArray_ = 0, textureUnit_ = 0;
    GLint blendEquation_ = 0, blendAlphaEquation_ = 0, blendSource_ = 0, blendTarget_ = 0;
    GLint blendAlphaSource_ = 0, blendAlphaTarget_ = 0;
    GLint clipOrigin_ = 0, clipDepth_ = 0;  // only with gl::ClipControl
    GLint depthMask_ = 0, depthFunction_ = 0, culledFace_ = 0, frontFace_ = 0;
    std::array<GLint, 4> viewport_{}, scissor_{}, colorMask_{};
    std::array<GLfloat, 2> depthRange_{};
    std::array<GLint, 6> unpacking_{};
    std::array<GLint, 8> buffers_{};
    std::array<TextureUnit, textureUnits> units_{};
    std::array<IndexedBuffer, VCT_UBO_COUNT> uniformBuffers_{};
    std::array<IndexedBuffer, VCT_SSBO_COUNT> storageBuffers_{};
    std::array<Image, VCT_IMAGE_COUNT> images_{};
};

}  // namespace vct
