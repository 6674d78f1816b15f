// A render pass: all that is drawn into a framebuffer before another one is bound. A tile-based GPU reads
// every attachment from memory at the start of a pass and writes it back at the end, unless it is told that
// nobody needs the texels.
#pragma once

#include <array>
#include <vector>

#include "gl/objects.h"

namespace vct::gl {

// The start of a pass. Every attachment is cleared or invalidated as a whole, so none is read from memory.
enum class Load {
    clear,       // colours to a given one (integers to 0), depth to 1
    invalidate,  // the pass draws every pixel
};

// The attachments that somebody reads after the pass. The end of the pass invalidates the others.
enum class Store { all, colors };

class RenderPass {
  public:
    // Binds the framebuffer, sets the viewport to all of it and turns culling off. With a depth attachment
    // the depth test is GL_LESS and depth is written; without one the test is off. The scissor test must be
    // off.
    explicit RenderPass(const Framebuffer& framebuffer, Load load = Load::clear, Store store = Store::all,
                        const std::array<GLfloat, 4>& color = {});
    // The framebuffer must still be bound.
    ~RenderPass();
    RenderPass(const RenderPass&) = delete;
    RenderPass& operator=(const RenderPass&) = delete;

  private:
    std::vector<GLenum> unread_;  // after the pass
};

}  // namespace vct::gl
