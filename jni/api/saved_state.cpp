#include "api/saved_state.h"

#include "gl/objects.h"

namespace vct {

namespace {

constexpr std::array<GLenum, 4> textureTargets{GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY,
                                               GL_TEXTURE_CUBE_MAP};
constexpr std::array<GLenum, 4> textureBindings{GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D,
                                                GL_TEXTURE_BINDING_2D_ARRAY, GL_TEXTURE_BINDING_CUBE_MAP};
constexpr std::array<GLenum, 6> unpackParameters{GL_UNPACK_ALIGNMENT,    GL_UNPACK_ROW_LENGTH,
                                                 GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS,
                                                 GL_UNPACK_SKIP_ROWS,    GL_UNPACK_SKIP_IMAGES};
constexpr std::array<GLenum, 8> bufferTargets{
    GL_ARRAY_BUFFER,      GL_UNIFORM_BUFFER,       GL_SHADER_STORAGE_BUFFER,    GL_COPY_READ_BUFFER,
    GL_COPY_WRITE_BUFFER, GL_DRAW_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER, GL_PIXEL_UNPACK_BUFFER};
constexpr std::array<GLenum, 8> bufferBindings{GL_ARRAY_BUFFER_BINDING,
                                               GL_UNIFORM_BUFFER_BINDING,
                                               GL_SHADER_STORAGE_BUFFER_BINDING,
                                               GL_COPY_READ_BUFFER_BINDING,
                                               GL_COPY_WRITE_BUFFER_BINDING,
                                               GL_DRAW_INDIRECT_BUFFER_BINDING,
                                               GL_DISPATCH_INDIRECT_BUFFER_BINDING,
                                               GL_PIXEL_UNPACK_BUFFER_BINDING};

template <class Units>
GLenum unitAt(const Units& units, std::size_t index) {
    const bool isLast = index + 1 == units.size();
    return GL_TEXTURE0 + static_cast<GLenum>(isLast ? gl::scratchTextureUnit : static_cast<int>(index));
}

GLint integer(GLenum name) {
    GLint value = 0;
    gl::GetIntegerv(name, &value);
    return value;
}

GLint integer(GLenum name, std::size_t index) {
    GLint value = 0;
    gl::GetIntegeri_v(name, static_cast<GLuint>(index), &value);
    return value;
}

// Objects of the library's own may have been bound, and deleted since.
GLuint existing(GLint name, decltype(gl::IsTexture) exists) {
    return exists(static_cast<GLuint>(name)) != GL_FALSE ? static_cast<GLuint>(name) : 0;
}

template <class Buffers>
void saveIndexed(Buffers& buffers, GLenum binding, GLenum start, GLenum size) {
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        buffers[i].buffer = integer(binding, i);
        gl::GetInteger64i_v(start, static_cast<GLuint>(i), &buffers[i].start);
        gl::GetInteger64i_v(size, static_cast<GLuint>(i), &buffers[i].size);
    }
}

template <class Buffers>
void restoreIndexed(const Buffers& buffers, GLenum target) {
    for (GLuint i = 0; i < buffers.size(); ++i) {
        const GLuint name = existing(buffers[i].buffer, gl::IsBuffer);
        if (buffers[i].size > 0 && name != 0)
            gl::BindBufferRange(target, i, name, static_cast<GLintptr>(buffers[i].start),
                                static_cast<GLsizeiptr>(buffers[i].size));
        else
            gl::BindBufferBase(target, i, name);
    }
}

}  // namespace

SavedState::SavedState() {
    // The limit is needed because some drivers return errors for ever without a context.
    for (int i = 0; i < 8 && gl::GetError() != GL_NO_ERROR; ++i) {
    }
    for (std::size_t i = 0; i < switches.size(); ++i) {
        enabled_[i] = integer(switches[i]);
        if (enabled_[i] != GL_FALSE) gl::Disable(switches[i]);
    }
    drawFramebuffer_ = integer(GL_DRAW_FRAMEBUFFER_BINDING);
    readFramebuffer_ = integer(GL_READ_FRAMEBUFFER_BINDING);
    program_ = integer(GL_CURRENT_PROGRAM);
    vertexArray_ = integer(GL_VERTEX_ARRAY_BINDING);
    if (gl::ClipControl != nullptr) {
        clipOrigin_ = integer(GL_CLIP_ORIGIN_EXT);
        clipDepth_ = integer(GL_CLIP_DEPTH_MODE_EXT);
        gl::ClipControl(GL_LOWER_LEFT_EXT, GL_NEGATIVE_ONE_TO_ONE_EXT);
    }
    depthMask_ = integer(GL_DEPTH_WRITEMASK);
    depthFunction_ = integer(GL_DEPTH_FUNC);
    culledFace_ = integer(GL_CULL_FACE_MODE);
    frontFace_ = integer(GL_FRONT_FACE);
    blendEquation_ = integer(GL_BLEND_EQUATION_RGB);
    blendAlphaEquation_ = integer(GL_BLEND_EQUATION_ALPHA);
    blendSource_ = integer(GL_BLEND_SRC_RGB);
    blendTarget_ = integer(GL_BLEND_DST_RGB);
    blendAlphaSource_ = integer(GL_BLEND_SRC_ALPHA);
    blendAlphaTarget_ = integer(GL_BLEND_DST_ALPHA);
    gl::GetIntegerv(GL_VIEWPORT, viewport_.data());
    gl::GetIntegerv(GL_SCISSOR_BOX, scissor_.data());
    gl::GetIntegerv(GL_COLOR_WRITEMASK, colorMask_.data());
    gl::GetFloatv(GL_DEPTH_RANGE, depthRange_.data());
    for (std::size_t i = 0; i < unpackParameters.size(); ++i)
        unpacking_[i] = integer(unpackParameters[i]);
    for (std::size_t i = 0; i < bufferTargets.size(); ++i)
        buffers_[i] = integer(bufferBindings[i]);
    saveIndexed(uniformBuffers_, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE);
    saveIndexed(storageBuffers_, GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START,
                GL_SHADER_STORAGE_BUFFER_SIZE);
    for (std::size_t i = 0; i < images_.size(); ++i)
        images_[i] = {integer(GL_IMAGE_BINDING_NAME, i),    integer(GL_IMAGE_BINDING_LEVEL, i),
                      integer(GL_IMAGE_BINDING_LAYERED, i), integer(GL_IMAGE_BINDING_LAYER, i),
                      integer(GL_IMAGE_BINDING_ACCESS, i),  integer(GL_IMAGE_BINDING_FORMAT, i)};
    textureUnit_ = integer(GL_ACTIVE_TEXTURE);
    for (std::size_t i = 0; i < units_.size(); ++i) {
        gl::ActiveTexture(unitAt(units_, i));
        for (std::size_t target = 0; target < textureTargets.size(); ++target)
            units_[i].textures[target] = integer(textureBindings[target]);
        units_[i].sampler = integer(GL_SAMPLER_BINDING);
        // A sampler would override the parameters of the engine's textures.
        gl::BindSampler(unitAt(units_, i) - GL_TEXTURE0, 0);
    }

    gl::ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl::DepthRangef(0.0F, 1.0F);
    for (const GLenum parameter : unpackParameters)
        gl::PixelStorei(parameter, parameter == GL_UNPACK_ALIGNMENT ? 4 : 0);
    gl::BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

SavedState::~SavedState() {
    for (std::size_t i = 0; i < units_.size(); ++i) {
        gl::ActiveTexture(unitAt(units_, i));
        for (std::size_t target = 0; target < textureTargets.size(); ++target)
            gl::BindTexture(textureTargets[target], existing(units_[i].textures[target], gl::IsTexture));
        gl::BindSampler(unitAt(units_, i) - GL_TEXTURE0, static_cast<GLuint>(units_[i].sampler));
    }
    gl::ActiveTexture(static_cast<GLenum>(textureUnit_));
    for (GLuint i = 0; i < images_.size(); ++i) {
        const Image& image = images_[i];
        gl::BindImageTexture(i, existing(image.texture, gl::IsTexture), image.level,
                             static_cast<GLboolean>(image.layered), image.layer,
                             static_cast<GLenum>(image.access), static_cast<GLenum>(image.format));
    }
    // Binding to an index also binds to the target itself, so the targets come last.
    restoreIndexed(uniformBuffers_, GL_UNIFORM_BUFFER);
    restoreIndexed(storageBuffers_, GL_SHADER_STORAGE_BUFFER);
    for (std::size_t i = 0; i < bufferTargets.size(); ++i)
        gl::BindBuffer(bufferTargets[i], existing(buffers_[i], gl::IsBuffer));
    for (std::size_t i = 0; i < unpackParameters.size(); ++i)
        gl::PixelStorei(unpackParameters[i], unpacking_[i]);
    for (std::size_t i = 0; i < switches.size(); ++i)
        (enabled_[i] != GL_FALSE ? gl::Enable : gl::Disable)(switches[i]);
    gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer_));
    gl::BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFramebuffer_));
    gl::UseProgram(static_cast<GLuint>(program_));
    gl::BindVertexArray(static_cast<GLuint>(vertexArray_));
    gl::BlendEquationSeparate(static_cast<GLenum>(blendEquation_), static_cast<GLenum>(blendAlphaEquation_));
    gl::BlendFuncSeparate(static_cast<GLenum>(blendSource_), static_cast<GLenum>(blendTarget_),
                          static_cast<GLenum>(blendAlphaSource_), static_cast<GLenum>(blendAlphaTarget_));
    gl::DepthMask(static_cast<GLboolean>(depthMask_));
    gl::DepthFunc(static_cast<GLenum>(depthFunction_));
    gl::CullFace(static_cast<GLenum>(culledFace_));
    gl::FrontFace(static_cast<GLenum>(frontFace_));
    gl::Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    gl::Scissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
    gl::ColorMask(static_cast<GLboolean>(colorMask_[0]), static_cast<GLboolean>(colorMask_[1]),
                  static_cast<GLboolean>(colorMask_[2]), static_cast<GLboolean>(colorMask_[3]));
    gl::DepthRangef(depthRange_[0], depthRange_[1]);
    if (gl::ClipControl != nullptr)
        gl::ClipControl(static_cast<GLenum>(clipOrigin_), static_cast<GLenum>(clipDepth_));
}

}  // namespace vct
