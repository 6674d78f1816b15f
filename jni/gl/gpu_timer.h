// Time that the GPU itself measures: GL_EXT_disjoint_timer_query.
#pragma once

#include "gl/objects.h"

namespace vct::gl {

// Bits of the GPU's clock; 0 where it has none. Only on a context with the extension.
inline int gpuTimerBits() {
    GLint bits = 0;
    if (GetQueryObjectui64v != nullptr) GetQueryiv(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
    return bits;
}

// True where the GPU's clock jumped since the last call (a change of frequency, another app): what was
// measured meanwhile means nothing.
inline bool gpuTimerWasDisjoint() {
    GLint disjoint = 0;
    GetIntegerv(GL_GPU_DISJOINT_EXT, &disjoint);
    return disjoint != 0;
}

// One query at a time. Only where gpuTimerBits() > 0.
class GpuTimer {
  public:
    void begin() { BeginQuery(GL_TIME_ELAPSED_EXT, handle_.get()); }
    void stop() { EndQuery(GL_TIME_ELAPSED_EXT); }
    // Waits for the GPU. Milliseconds from begin() to stop().
    double resultMs() const {
        GLuint64 nanoseconds = 0;
        GetQueryObjectui64v(handle_.get(), GL_QUERY_RESULT, &nanoseconds);
        return static_cast<double>(nanoseconds) * 1e-6;
    }

  private:
    Handle<&DeleteQueries> handle_{generate(GenQueries)};
};

}  // namespace vct::gl
