// A render pass: all draws into a framebuffer until another one is bound. A tile-based GPU reads every
// attachment from memory at the start of a pass and writes it back at the end, unless the attachment is
// cleared or invalidated.
#pragma once

#include <array>
#include <vector>

#include "gl/objects.h"

namespace vct::gl {

// The treatment of all attachments at the start of a pass. All but `keep` spare reading them from memory.
enum class Load {
    clear,       // clears colours to a given one, integers to 0 and depth to 1
    invalidate,  // for a pass that draws every pixel
    keep,        // for a pass that draws a part of the picture anew
};

// The attachments that are read after the pass. The others are invalidated at its end.
enum class Store { all, colors };

class RenderPass {
  public:
    // Binds the framebuffer, sets the viewport to its size and disables culling. With a depth attachment,
    // sets the depth test to GL_LESS and enables depth writes; without one, disables the test. The scissor
    // test must be disabled.
    explicit RenderPass(const Framebuffer& framebuffer, Load load = Load::clear, Store store = Store::all,
                        const std::array<GLfloat, 4>& color = {});
    // The framebuffer must still be bound.
    ~RenderPass();
    RenderPass(const RenderPass&) = delete;
    RenderPass& operator=(const RenderPass&) = delete;

  private:
    std::vector<GLenum> unread_;  // attachments to invalidate at the end
};

}  // namespace vct::gl
