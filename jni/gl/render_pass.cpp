#include "gl/render_pass.h"

namespace vct::gl {

namespace {

using Kind = Framebuffer::Attachment::Kind;

void invalidate(const std::vector<GLenum>& attachments) {
    if (!attachments.empty())
        InvalidateFramebuffer(GL_FRAMEBUFFER, static_cast<GLsizei>(attachments.size()), attachments.data());
}

}  // namespace

RenderPass::RenderPass(const Framebuffer& framebuffer, Load load, Store store,
                       const std::array<GLfloat, 4>& color) {
    framebuffer.bind();
    Disable(GL_CULL_FACE);
    bool hasDepth = false;
    for (const Framebuffer::Attachment& attachment : framebuffer.attachments())
        hasDepth = hasDepth || attachment.kind == Kind::depth;
    (hasDepth ? Enable : Disable)(GL_DEPTH_TEST);
    if (hasDepth) {
        DepthFunc(GL_LESS);
        DepthMask(GL_TRUE);  // also applies to clears
    }

    std::vector<GLenum> invalid;
    GLint drawBuffer = 0;
    for (const auto& [name, kind] : framebuffer.attachments()) {
        const bool isColor = kind == Kind::color || kind == Kind::integers;
        if (store == Store::colors && !isColor) unread_.push_back(name);
        if (load == Load::invalidate || kind == Kind::unused) {
            invalid.push_back(name);
        } else if (load == Load::keep) {
            // Reads the attachment from memory.
        } else if (kind == Kind::color) {
            ClearBufferfv(GL_COLOR, drawBuffer, color.data());
        } else if (kind == Kind::integers) {
            const GLuint zero[4] = {0, 0, 0, 0};
            ClearBufferuiv(GL_COLOR, drawBuffer, zero);
        } else {
            const GLfloat far = 1.0F;
            ClearBufferfv(GL_DEPTH, 0, &far);
        }
        drawBuffer += isColor ? 1 : 0;
    }
    invalidate(invalid);
}

// Some Adreno drivers apply the invalidation at the end of a pass to the whole pass (Filament,
// OpenGLContext.h, invalidate_end_only_if_invalidate_start). This is harmless, because no pass reads its
// attachments at the start.
RenderPass::~RenderPass() {
    invalidate(unread_);
}

}  // namespace vct::gl
