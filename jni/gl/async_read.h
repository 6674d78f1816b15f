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

    // Queues a copy of the buffer's first bytes. If an earlier copy has not been read, finish() queues this
    // one: a GPU that is always a frame behind would otherwise never be heard.
    void start(const Buffer& source);
    // If the GPU has made a copy, writes it to `destination` and returns true, once per copy. `source`: the
    // buffer of start(), for a copy that has waited.
    bool finish(void* destination, const Buffer& source);

  private:
    Buffer copy_;
    GLsync fence_ = nullptr;
    bool waits_ = false;  // start() was called while an earlier copy had not been read
};

}  // namespace vct::gl
