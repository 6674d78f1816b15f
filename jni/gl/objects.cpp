#include "gl/objects.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "core/memory.h"
#include "core/number_text.h"
#include "gl/debug.h"

namespace vct::gl {

namespace {

std::size_t texelBytes(GLenum format) {
    switch (format) {
        case GL_RG8:
        case GL_DEPTH_COMPONENT16:
            return 2;
        case GL_RGBA8:
        case GL_SRGB8_ALPHA8:
        case GL_RG16UI:
        case GL_RG16F:
        case GL_R32UI:
        case GL_R11F_G11F_B10F:
        case GL_DEPTH_COMPONENT24:
        case GL_DEPTH_COMPONENT32F:
            return 4;
        case GL_RGBA16UI:
        case GL_RGBA16F:
            return 8;
        case GL_RGBA32F:
            return 16;
        default:
            throw Error("texelBytes: format " + std::to_string(format) +
                        " is not in its table; add it there");
    }
}

bool isInteger(GLenum format) {
    return format == GL_R32UI || format == GL_RG16UI || format == GL_RGBA16UI;
}

// Checked here because the driver's error says only that a value is invalid.
void throwIfTooLarge(const std::string& label, GLenum target, int width, int height, int depth) {
    GLint most = 0;
    GetIntegerv(target == GL_TEXTURE_3D         ? GL_MAX_3D_TEXTURE_SIZE
                : target == GL_TEXTURE_CUBE_MAP ? GL_MAX_CUBE_MAP_TEXTURE_SIZE
                                                : GL_MAX_TEXTURE_SIZE,
                &most);
    if (std::max({width, height, depth}) <= most) return;
    throw Error(label + " needs " + std::to_string(width) + " x " + std::to_string(height) +
                (target == GL_TEXTURE_3D ? " x " + std::to_string(depth) : "") +
                " texels, and the driver allows " + std::to_string(most) +
                " per side; use a coarser grid, a smaller picture or smaller textures");
}

// Storage buffers are bound as one block. Phones limit the size of a block to 128 MiB or more.
void throwIfTooLarge(const std::string& label, GLenum target, std::size_t bytes) {
    if (target != GL_SHADER_STORAGE_BUFFER) return;
    GLint most = 0;
    GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    if (bytes > static_cast<std::size_t>(most))
        throw Error(label + " needs " + megabytesText(bytes) + ", and the driver allows " +
                    megabytesText(static_cast<std::size_t>(most)) +
                    " in a storage block (GL_MAX_SHADER_STORAGE_BLOCK_SIZE); use a coarser grid");
}

// Storage calls can only give these two errors, because earlier errors are reported by their own pass.
void throwIfOutOfMemory(const std::string& label, std::size_t bytes) {
    const GLenum error = GetError();
    if (error == GL_CONTEXT_LOST) throw ContextLost(label + ": the GL context was lost");
    if (error != GL_OUT_OF_MEMORY) return;
    const std::string remedy = "; use fewer voxels (a coarser grid) or a smaller picture";
    const std::size_t available = availableMemory();
    if (bytes < available && available != std::numeric_limits<std::size_t>::max())
        throw Error(
            "the driver refuses " + label + " (" + megabytesText(bytes) + "), although " +
            megabytesText(available) +
            " of main memory are free: it is more than the driver allows in one piece, or than the GPU "
            "has" +
            remedy);
    throw Error("not enough memory for " + label + " (" + megabytesText(bytes) + ")" + remedy + ", or " +
                memoryRemedy());
}

}  // namespace

std::size_t textureBytes(GLenum format, int width, int height, int depth, int levels) {
    std::size_t texels = 0;
    for (int level = 0; level < levels; ++level)
        texels += static_cast<std::size_t>(std::max(width >> level, 1)) * std::max(height >> level, 1) *
                  std::max(depth >> level, 1);
    return texels * texelBytes(format);
}

Texture Texture::create(const std::string& label, GLenum target, GLenum format, int width, int height,
                        int depth, int levels) {
    throwIfTooLarge(label, target, width, height, depth);
    Texture texture;
    texture.handle_ = Handle<&DeleteTextures>(generate(GenTextures));
    texture.target_ = target;
    texture.format_ = format;
    texture.width_ = width;
    texture.height_ = height;
    texture.levels_ = levels;
    texture.bytes_ =
        (target == GL_TEXTURE_CUBE_MAP ? 6 : 1) * textureBytes(format, width, height, depth, levels);
    texture.label_ = label;
    texture.bind(scratchTextureUnit);
    if (target == GL_TEXTURE_3D || target == GL_TEXTURE_2D_ARRAY)
        TexStorage3D(target, levels, format, width, height, depth);
    else
        TexStorage2D(target, levels, format, width, height);
    throwIfOutOfMemory(label, texture.bytes_);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        texture.setParameter(wrap, GL_CLAMP_TO_EDGE);
    gl::label(GL_TEXTURE, texture.name(), label);
    return texture;
}

Texture Texture::make2d(const std::string& label, GLenum format, int width, int height, int levels) {
    Texture texture = create(label, GL_TEXTURE_2D, format, width, height, 1, levels);
    texture.setFilter(GL_NEAREST, GL_NEAREST);
    return texture;
}

Texture Texture::make3d(const std::string& label, GLenum format, int width, int height, int depth,
                        int levels) {
    Texture texture = create(label, GL_TEXTURE_3D, format, width, height, depth, levels);
    texture.setFilter(levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST, GL_NEAREST);
    return texture;
}

Texture Texture::make2dArray(const std::string& label, GLenum format, int width, int height, int layers) {
    Texture texture = create(label, GL_TEXTURE_2D_ARRAY, format, width, height, layers, 1);
    texture.setFilter(GL_NEAREST, GL_NEAREST);
    return texture;
}

Texture Texture::makeCube(const std::string& label, GLenum format, int side, int levels) {
    Texture texture = create(label, GL_TEXTURE_CUBE_MAP, format, side, side, 1, levels);
    texture.setFilter(levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST, GL_NEAREST);
    return texture;
}

Texture Texture::wrapExternal(GLuint name) {
    Texture texture;
    texture.isExternal_ = name;
    return texture;
}

void Texture::bind(int unit) const {
    ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    BindTexture(target_, name());
}

void Texture::bindImage(int unit, int level, GLenum access) const {
    BindImageTexture(static_cast<GLuint>(unit), name(), level, GL_TRUE, 0, access, format_);
}

void Texture::setFilter(GLenum minFilter, GLenum magFilter) const {
    setParameter(GL_TEXTURE_MIN_FILTER, minFilter);
    setParameter(GL_TEXTURE_MAG_FILTER, magFilter);
}

void Texture::setParameter(GLenum parameter, GLenum value) const {
    bind(scratchTextureUnit);
    TexParameteri(target_, parameter, static_cast<GLint>(value));
}

PlainSampler::PlainSampler() {
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        SamplerParameteri(handle_.get(), filter, GL_NEAREST);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        SamplerParameteri(handle_.get(), wrap, GL_CLAMP_TO_EDGE);
    SamplerParameteri(handle_.get(), GL_TEXTURE_COMPARE_MODE, GL_NONE);
}

Buffer::Buffer(const std::string& label, GLenum target, std::size_t bytes, const void* data, GLenum usage)
    : handle_(generate(GenBuffers)), bytes_(bytes), label_(label) {
    throwIfTooLarge(label, target, bytes);
    BindBuffer(target, name());
    BufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
    throwIfOutOfMemory(label, bytes);
    gl::label(GL_BUFFER, name(), label);
}

void Buffer::read(void* destination, std::size_t size, std::size_t offset) const {
    if (size == 0) return;
    MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    BindBuffer(GL_COPY_READ_BUFFER, name());
    const void* mapped = MapBufferRange(GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset),
                                        static_cast<GLsizeiptr>(size), GL_MAP_READ_BIT);
    if (mapped == nullptr)
        throw Error("the driver cannot map the buffer '" + label_ + "' for reading; free memory");
    std::memcpy(destination, mapped, size);
    UnmapBuffer(GL_COPY_READ_BUFFER);
}

void Framebuffer::create(const std::string& label) {
    handle_ = Handle<&DeleteFramebuffers>(generate(GenFramebuffers));
    BindFramebuffer(GL_FRAMEBUFFER, handle_.get());
    gl::label(GL_FRAMEBUFFER, handle_.get(), label);
}

void Framebuffer::check(const std::string& label) const {
    const GLenum status = CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error("the driver cannot draw into the framebuffer '" + label + "' (status " +
                    std::to_string(status) + "); the program `vct info` shows which format it lacks");
}

Framebuffer::Framebuffer(const std::string& label, const std::vector<const Texture*>& colors,
                         const Texture* depth, int level) {
    create(label);
    std::vector<GLenum> drawBuffers;
    for (std::size_t i = 0; i < colors.size(); ++i)
        drawBuffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    const auto attach = [&] {
        for (std::size_t i = 0; i < colors.size(); ++i)
            FramebufferTexture2D(GL_FRAMEBUFFER, drawBuffers[i], GL_TEXTURE_2D, colors[i]->name(), level);
        if (depth != nullptr)
            FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth->name(), level);
    };
    attach();
    using Kind = Attachment::Kind;
    for (std::size_t i = 0; i < colors.size(); ++i)
        attachments_.push_back(
            {drawBuffers[i], isInteger(colors[i]->format()) ? Kind::integers : Kind::color});
    if (depth != nullptr) attachments_.push_back({GL_DEPTH_ATTACHMENT, Kind::depth});
    if (drawBuffers.empty()) drawBuffers.push_back(GL_NONE);
    DrawBuffers(static_cast<GLsizei>(drawBuffers.size()), drawBuffers.data());
    const Texture& any = depth != nullptr ? *depth : *colors.front();
    width_ = std::max(any.width() >> level, 1);
    height_ = std::max(any.height() >> level, 1);
    check(label);
    // Mali-T drivers before r26, as on the Galaxy S7, lose the attachments when the status is queried (Skia,
    // skbug 12640).
    if (!colors.empty()) attach();
}

// Adreno 4xx loses drawn content if the bound framebuffer is deleted (Chromium, gpu_driver_bug_list #102).
Framebuffer::~Framebuffer() {
    if (handle_.get() == 0) return;
    GLint bound = 0;
    GetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    if (static_cast<GLuint>(bound) == handle_.get()) BindFramebuffer(GL_FRAMEBUFFER, 0);
}

Framebuffer::Framebuffer(const std::string& label, int width, int height, int samples)
    : width_(width), height_(height) {
    create(label);
    if (samples == 1) {
        FramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, width);
        FramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, height);
        const GLenum none = GL_NONE;
        DrawBuffers(1, &none);
        check(label);
        return;
    }
    // ANGLE takes one sample per pixel without a target that is drawn to, whatever
    // GL_FRAMEBUFFER_DEFAULT_SAMPLES says.
    GLint bound = 0;
    GetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
    samples_ = Handle<&DeleteRenderbuffers>(generate(GenRenderbuffers));
    BindRenderbuffer(GL_RENDERBUFFER, samples_.get());
    RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_R8, width, height);
    BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
    attachments_ = {{GL_COLOR_ATTACHMENT0, Attachment::Kind::unused}};
    const auto attach = [&] {
        FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_.get());
    };
    attach();
    check(label);
    attach();  // see above
}

Framebuffer::Framebuffer(const std::string& label, const Texture& depths, GLint layer)
    : attachments_{{GL_DEPTH_ATTACHMENT, Attachment::Kind::depth}},
      width_(depths.width()),
      height_(depths.height()) {
    create(label);
    FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depths.name(), 0, layer);
    const GLenum none = GL_NONE;
    DrawBuffers(1, &none);
    check(label);
}

Framebuffer Framebuffer::window(int width, int height) {
    using Kind = Attachment::Kind;
    Framebuffer window;
    window.attachments_ = {{GL_COLOR, Kind::color}, {GL_DEPTH, Kind::unused}, {GL_STENCIL, Kind::unused}};
    window.width_ = width;
    window.height_ = height;
    return window;
}

void Framebuffer::bind() const {
    BindFramebuffer(GL_FRAMEBUFFER, handle_.get());
    Viewport(0, 0, width_, height_);
}

// OpenGL ES cannot clear a 3D texture, so each slice is cleared as a colour target.
void clearTexture3d(const Texture& texture, int depth) {
    {
        const Framebuffer framebuffer(texture.label() + ", to be emptied", 1, 1);
        framebuffer.bind();
        const GLenum target = GL_COLOR_ATTACHMENT0;
        DrawBuffers(1, &target);
        ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        const GLuint integers[4] = {0, 0, 0, 0};
        const GLfloat floats[4] = {0.0F, 0.0F, 0.0F, 0.0F};
        for (int level = 0; level < texture.levels(); ++level)
            for (int slice = 0; slice < std::max(depth >> level, 1); ++slice) {
                FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture.name(), level, slice);
                if (isInteger(texture.format()))
                    ClearBufferuiv(GL_COLOR, 0, integers);
                else
                    ClearBufferfv(GL_COLOR, 0, floats);
            }
    }
    // GL needs no barrier here, but on Adreno 640 compute shaders read the old texels without one (ANGLE,
    // angle_end2end_tests_expectations.txt, ClearThenSampleWithCompute and DrawDispatchImageReadDraw,
    // 42264513).
    MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace vct::gl
