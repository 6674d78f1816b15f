#include "support/render_passes.h"

#include <cstring>
#include <map>

#include "gl/objects.h"

namespace vct::test {

namespace {

struct Attachment {
    std::int64_t texture = 0;
    bool isDefined = false;  // cleared or invalidated since the pass began
    bool isStored = false;   // drawn into, and not invalidated afterwards
};
using Attachments = std::map<std::int64_t, Attachment>;

std::string nameOf(std::int64_t attachment) {
    if (attachment == GL_DEPTH || attachment == GL_DEPTH_ATTACHMENT) return "depth";
    if (attachment == GL_STENCIL) return "stencil";
    if (attachment == GL_COLOR) return "color";
    return "color " + std::to_string(attachment - GL_COLOR_ATTACHMENT0);
}

class Replay {
  public:
    void make(const gl::Call& call) {
        const auto is = [&](const char* name) { return std::strcmp(call.name, name) == 0; };
        const std::vector<std::int64_t>& a = call.arguments;
        if (is("PushDebugGroup")) groups_.push_back(call.text);
        if (is("PopDebugGroup") && !groups_.empty()) groups_.pop_back();
        if (is("BindFramebuffer")) begin(a[1]);
        if (is("DeleteFramebuffers"))
            for (const GLuint framebuffer : call.names)
                framebuffers_.erase(framebuffer);
        if (is("FramebufferTexture2D")) framebuffers_[bound_][a[1]] = {a[3]};
        if (is("FramebufferTextureLayer")) framebuffers_[bound_][a[1]] = {a[2]};
        if (is("Enable") && a[0] == GL_SCISSOR_TEST) scissors_ = true;
        if (is("Disable") && a[0] == GL_SCISSOR_TEST) scissors_ = false;
        if (is("ClearBufferfv") || is("ClearBufferuiv")) clear(a[0], a[1]);
        if (is("InvalidateFramebuffer"))
            for (const GLuint attachment : call.names)
                invalidate(attachment);
        if (std::strncmp(call.name, "DrawArrays", 10) == 0 ||
            std::strncmp(call.name, "DrawElements", 12) == 0)
            draw();
        if (is("ActiveTexture")) unit_ = a[0] - GL_TEXTURE0;
        if (is("BindTexture") && unit_ != gl::scratchTextureUnit) sampled_.insert(a[1]);
    }

    RenderPasses result(const std::set<std::int64_t>& outputs) {
        begin(0);
        for (const auto& [texture, name] : stored_)
            if (sampled_.count(texture) == 0 && outputs.count(texture) == 0) passes_.unread.insert(name);
        return passes_;
    }

  private:
    void begin(std::int64_t framebuffer) {
        for (auto& [name, attachment] : framebuffers_[bound_]) {
            if (attachment.isStored && !(bound_ == 0 && name == GL_COLOR))
                stored_.emplace(attachment.texture, drawnIn_ + ": " + nameOf(name));
            attachment.isDefined = attachment.isStored = false;
        }
        bound_ = framebuffer;
        hasDrawn_ = false;
    }

    void clear(std::int64_t buffer, std::int64_t drawBuffer) {
        if (scissors_) return;
        if (bound_ != 0)
            buffer = buffer == GL_COLOR ? GL_COLOR_ATTACHMENT0 + drawBuffer : GL_DEPTH_ATTACHMENT;
        const auto found = framebuffers_[bound_].find(buffer);
        if (found != framebuffers_[bound_].end()) found->second.isDefined = true;
    }

    void invalidate(std::int64_t attachment) {
        const auto found = framebuffers_[bound_].find(attachment);
        if (found != framebuffers_[bound_].end()) found->second = {found->second.texture, true, false};
    }

    void draw() {
        Attachments& attachments = framebuffers_[bound_];
        if (!attachments.empty() && !hasDrawn_) ++passes_.count;
        hasDrawn_ = true;
        drawnIn_ = groups_.empty() ? "no group" : groups_.back();
        for (auto& [name, attachment] : attachments) {
            if (!attachment.isDefined) passes_.loaded.insert(drawnIn_ + ": " + nameOf(name));
            attachment.isStored = true;
        }
    }

    RenderPasses passes_;
    std::map<std::int64_t, Attachments> framebuffers_{
        {0, {{GL_COLOR, {}}, {GL_DEPTH, {}}, {GL_STENCIL, {}}}}};
    std::int64_t bound_ = 0, unit_ = 0;
    bool scissors_ = false, hasDrawn_ = false;
    std::vector<std::string> groups_;
    std::string drawnIn_;
    std::multimap<std::int64_t, std::string> stored_;
    std::set<std::int64_t> sampled_;
};

}  // namespace

RenderPasses renderPassesOf(const std::vector<gl::Call>& calls, const std::set<std::int64_t>& outputs) {
    Replay replay;
    for (const gl::Call& call : calls)
        replay.make(call);
    return replay.result(outputs);
}

}  // namespace vct::test
