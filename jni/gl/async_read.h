// Brings a buffer's content to the CPU without waiting for the GPU: a copy, and a fence behind it.
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

    // Copies the buffer's first bytes when the GPU comes to it. A copy that was not read is given up.
    void start(const Buffer& source);
    // Whether the GPU has made the copy, which is read then, once.
    bool finish(void* destination);

  private:
    Buffer copy_;
    GLsync fence_ = nullptr;
};

}  // namespace vct::gl
