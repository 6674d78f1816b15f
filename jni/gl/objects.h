// Small owners of GL objects: the constructor acquires or throws, the destructor releases, move-only.
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "gl/api.h"

namespace vct::gl {

// An object's name. `remove` is the entry point that deletes it: DeleteTextures or DeleteProgram, for
// example.
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

// A new name of GenTextures and its like.
inline GLuint generate(decltype(GenTextures) entryPoint) {
    GLuint name = 0;
    entryPoint(1, &name);
    return name;
}

// Textures are made and changed on this unit, so that no pass loses what it has bound. ES 3.0 has 32 units.
constexpr int scratchTextureUnit = 31;

// An immutable-storage texture. Throws vct::Error naming `label`, the size and the remedy where there is no
// memory for it, or where it is larger than the driver allows.
class Texture {
  public:
    Texture() = default;
    // `format` is sized (GL_RGBA16F); filter NEAREST, wrap CLAMP_TO_EDGE.
    static Texture make2d(const std::string& label, GLenum format, int width, int height, int levels = 1);
    static Texture make3d(const std::string& label, GLenum format, int width, int height, int depth,
                          int levels);
    static Texture make2dArray(const std::string& label, GLenum format, int width, int height, int layers);
    // Six squares.
    static Texture makeCube(const std::string& label, GLenum format, int side, int levels);

    // A 2D texture that somebody else owns: it is read, and neither changed nor deleted.
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
    // One level with all its layers, for shaders' image functions.
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

// A second way to read a texture, beside the texture's own parameters. Reads single texels of single levels,
// not compared: NEAREST, CLAMP_TO_EDGE, no comparison.
class PlainSampler {
  public:
    PlainSampler();
    // For whatever texture is bound to `unit`, until another sampler is.
    void bind(int unit) const { BindSampler(static_cast<GLuint>(unit), handle_.get()); }

  private:
    Handle<&DeleteSamplers> handle_{generate(GenSamplers)};
};

// Bytes of a texture's levels; `depth` is halved with each level too where it is not 1.
std::size_t textureBytes(GLenum format, int width, int height, int depth, int levels);

// Zeroes all levels of a 3D texture whose texels can be rendered to.
void clearTexture3d(const Texture& texture, int depth);

// Throws as Texture does; a storage buffer also where it is larger than a block may be.
class Buffer {
  public:
    Buffer() = default;
    Buffer(const std::string& label, GLenum target, std::size_t bytes, const void* data, GLenum usage);

    GLuint name() const { return handle_.get(); }
    std::size_t bytes() const { return bytes_; }
    const std::string& label() const { return label_; }
    void bind(GLenum target) const { BindBuffer(target, name()); }
    void bindBase(GLenum target, GLuint index) const { BindBufferBase(target, index, name()); }
    // Reads `size` bytes from `offset` on, after everything before has finished.
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

// A framebuffer with the colour targets in order and a depth target (or null), one level of each.
// Without targets, `width` and `height` give its default size (GL_FRAMEBUFFER_DEFAULT_WIDTH).
// RenderPass (gl/render_pass.h) draws into it.
class Framebuffer {
  public:
    struct Attachment {
        GLenum name;  // as in glInvalidateFramebuffer
        // A window may have depth and stencil: nothing is drawn with them.
        enum class Kind { color, integers, depth, unused } kind;
    };

    Framebuffer() = default;
    Framebuffer(const std::string& label, const std::vector<const Texture*>& colors, const Texture* depth,
                int level = 0);
    Framebuffer(const std::string& label, int width, int height);
    // Depth alone, in one layer of an array.
    Framebuffer(const std::string& label, const Texture& depths, GLint layer);
    // The default framebuffer of the current context.
    static Framebuffer window(int width, int height);
    ~Framebuffer();
    Framebuffer(Framebuffer&&) = default;
    Framebuffer& operator=(Framebuffer&&) = default;

    // Binds it for drawing and reading and sets the viewport to all of it.
    void bind() const;
    // Colours come first, in the order of the draw buffers.
    const std::vector<Attachment>& attachments() const { return attachments_; }

  private:
    void create(const std::string& label);
    void check(const std::string& label) const;
    Handle<&DeleteFramebuffers> handle_;
    std::vector<Attachment> attachments_;
    int width_ = 0, height_ = 0;
};

}  // namespace vct::gl
