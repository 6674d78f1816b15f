#include "gl/async_read.h"

namespace vct::gl {

AsyncRead::AsyncRead(const std::string& label, std::size_t bytes)
    : copy_(label, GL_COPY_WRITE_BUFFER, bytes, nullptr, GL_STREAM_READ) {}

AsyncRead::~AsyncRead() {
    DeleteSync(fence_);
}

void AsyncRead::start(const Buffer& source) {
    waits_ = fence_ != nullptr;
    if (waits_) return;
    MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    source.bind(GL_COPY_READ_BUFFER);
    copy_.bind(GL_COPY_WRITE_BUFFER);
    CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                      static_cast<GLsizeiptr>(copy_.bytes()));
    fence_ = FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

bool AsyncRead::finish(void* destination, const Buffer& source) {
    if (fence_ == nullptr) return false;
    const GLenum state = ClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) return false;
    DeleteSync(fence_);
    fence_ = nullptr;
    copy_.read(destination, copy_.bytes());
    if (waits_) start(source);
    return true;
}

}  // namespace vct::gl
