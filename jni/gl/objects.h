// Owners of GL objects. Constructors acquire or throw, destructors release; the types are move-only.
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "gl/api.h"

namespace vct::gl {

// Owns an object's name. `remove` is the entry point that deletes it, for example DeleteTextures or
// DeleteProgram.
template <auto* remove>
class Handle {
  public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    ~Handle() {
        if (name_ == 0) return;
        if constexpr (std::is_invocable_v<decltype(*remove), GLuint>)
            (*remove)(name_);
        else
            (*remove)(1, &name_);
    }
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    GLuint get() const { return name_; }

  private:
    GLuint name_ = 0;
};

// Returns a new name. `entryPoint` is GenTextures or a similar function.
inline GLuint generate(decltype(GenTextures) entryPoint) {
    GLuint name = 0;
    entryPoint(1, &name);
    return name;
}

// Textures are created and changed on this unit, so that no pass loses its bindings. ES 3.0 guarantees 32
// units.
constexpr int scratchTextureUnit = 31;

// A texture with immutable storage. Creation throws vct::Error with `label`, size and remedy if there is not
// enough memory, or if the texture is larger than the driver allows.
class Texture {
  public:
    Texture() = default;
    // `format` is a sized format such as GL_RGBA16F. The filter is NEAREST, the wrap mode CLAMP_TO_EDGE.
    static Texture make2d(const std::string& label, GLenum format, int width, int height, int levels = 1);
    static Texture make3d(const std::string& label, GLenum format, int width, int height, int depth,
                          int levels);
    static Texture make2dArray(const std::string& label, GLenum format, int width, int height, int layers);
    // A cube map; `side` is the side of its faces in texels.
    static Texture makeCube(const std::string& label, GLenum format, int side, int levels);

    // A 2D texture with another owner. It is neither changed nor deleted.
    static Texture wrapExternal(GLuint name);

    GLuint name() const { return isExternal_ != 0 ? isExternal_ : handle_.get(); }
    GLenum target() const { return target_; }
    GLenum format() const { return format_; }
    int width() const { return width_; }
    int height() const { return height_; }
    int levels() const { return levels_; }
    const std::string& label() const { return label_; }
    std::size_t bytes() const { return bytes_; }

    void bind(int unit) const;
    // Binds one level with all its layers for image access by shaders.
    void bindImage(int unit, int level, GLenum access) const;
    void setFilter(GLenum minFilter, GLenum magFilter) const;
    void setParameter(GLenum parameter, GLenum value) const;

  private:
    static Texture create(const std::string& label, GLenum target, GLenum format, int width, int height,
                          int depth, int levels);
    Handle<&DeleteTextures> handle_;
    GLuint isExternal_ = 0;
    GLenum target_ = GL_TEXTURE_2D;
    GLenum format_ = 0;
    int width_ = 0, height_ = 0, levels_ = 0;
    std::size_t bytes_ = 0;
    std::string label_;
};

// A sampler that reads a texture's texels without filter and comparison, whatever the texture's own
// parameters: NEAREST, CLAMP_TO_EDGE, no comparison.
class PlainSampler {
  public:
    PlainSampler();
    // Applies to any texture on `unit` until another sampler is bound.
    void bind(int unit) const { BindSampler(static_cast<GLuint>(unit), handle_.get()); }

  private:
    Handle<&DeleteSamplers> handle_{generate(GenSamplers)};
};

// Bytes of all levels of a texture. A `depth` above 1 is halved from level to level like width and height.
std::size_t textureBytes(GLenum format, int width, int height, int depth, int levels);

// Clears all levels of a 3D texture to 0. Its format must be renderable.
void clearTexture3d(const Texture& texture, int depth);

// A buffer. Creation throws as Texture's does, and also if a storage buffer exceeds the driver's block size.
class Buffer {
  public:
    Buffer() = default;
    Buffer(const std::string& label, GLenum target, std::size_t bytes, const void* data, GLenum usage);

    GLuint name() const { return handle_.get(); }
    std::size_t bytes() const { return bytes_; }
    const std::string& label() const { return label_; }
    void bind(GLenum target) const { BindBuffer(target, name()); }
    void bindBase(GLenum target, GLuint index) const { BindBufferBase(target, index, name()); }
    // Reads `size` bytes from `offset` on. Waits for the GPU.
    void read(void* destination, std::size_t size, std::size_t offset = 0) const;

  private:
    Handle<&DeleteBuffers> handle_;
    std::size_t bytes_ = 0;
    std::string label_;
};

class VertexArray {
  public:
    void bind() const { BindVertexArray(handle_.get()); }

  private:
    Handle<&DeleteVertexArrays> handle_{generate(GenVertexArrays)};
};

// A framebuffer: one level of each colour target, in order, and of a depth target, which may be null. Draw
// into it through RenderPass (gl/render_pass.h).
class Framebuffer {
  public:
    struct Attachment {
        GLenum name;  // as in glInvalidateFramebuffer
        // `unused`: no pass uses it, such as depth and stencil of a window.
        enum class Kind { color, integers, depth, unused } kind;
    };

    Framebuffer() = default;
    Framebuffer(const std::string& label, const std::vector<const Texture*>& colors, const Texture* depth,
                int level = 0);
    // A size and samples per pixel for fragments that write to buffers and images alone.
    Framebuffer(const std::string& label, int width, int height, int samples = 1);
    // One layer of an array texture as the depth target, without colour targets.
    Framebuffer(const std::string& label, const Texture& depths, GLint layer);
    // The default framebuffer of the current context.
    static Framebuffer window(int width, int height);
    ~Framebuffer();
    Framebuffer(Framebuffer&&) = default;
    Framebuffer& operator=(Framebuffer&&) = default;

    // Binds it for drawing and reading, and sets the viewport to its size.
    void bind() const;
    // Colours come first, in the order of the draw buffers.
    const std::vector<Attachment>& attachments() const { return attachments_; }

  private:
    void create(const std::string& label);
    void check(const std::string& label) const;
    Handle<&DeleteFramebuffers> handle_;
    Handle<&DeleteRenderbuffers> samples_;  // nobody reads it; 0 with one sample per pixel
    std::vector<Attachment> attachments_;
    int width_ = 0, height_ = 0;
};

}  // namespace vct::gl
