// Reads a buffer on the CPU without waiting for the GPU, through a copy and a fence.
#pragma once

#include <string>

#include "gl/objects.h"

namespace vct::gl {

class AsyncRead {
  public:
    AsyncRead(const std::string& label, std::size_t bytes);
    ~AsyncRead();
    AsyncRead(const AsyncRead&) = delete;
    AsyncRead& operator=(const AsyncRead&) = delete;

    // Queues a copy of the buffer's first bytes. Drops an earlier copy that has not been read.
    void start(const Buffer& source);
    // If the GPU has made the copy, writes it to `destination` and returns true, once per start().
    bool finish(void* destination);

  private:
    Buffer copy_;
    GLsync fence_ = nullptr;
};

}  // namespace vct::gl
