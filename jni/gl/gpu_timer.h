// Time by the GPU's own clock (GL_EXT_disjoint_timer_query).
#pragma once

#include "gl/objects.h"

namespace vct::gl {

// Bits of the GPU's clock; 0 without a clock or without the extension.
inline int gpuTimerBits() {
    GLint bits = 0;
    if (GetQueryObjectui64v != nullptr) GetQueryiv(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
    return bits;
}

// True if the GPU's clock has jumped in the time from the last call, for example by a change of frequency.
// Measurements in that time are then invalid.
inline bool gpuTimerWasDisjoint() {
    GLint disjoint = 0;
    GetIntegerv(GL_GPU_DISJOINT_EXT, &disjoint);
    return disjoint != 0;
}

// A query of elapsed time. Only one may be active at a time, and only if gpuTimerBits() > 0.
class GpuTimer {
  public:
    void begin() { BeginQuery(GL_TIME_ELAPSED_EXT, handle_.get()); }
    void stop() { EndQuery(GL_TIME_ELAPSED_EXT); }
    // Milliseconds from begin() to stop(). Waits for the GPU.
    double resultMs() const {
        GLuint64 nanoseconds = 0;
        GetQueryObjectui64v(handle_.get(), GL_QUERY_RESULT, &nanoseconds);
        return static_cast<double>(nanoseconds) * 1e-6;
    }

  private:
    Handle<&DeleteQueries> handle_{generate(GenQueries)};
};

}  // namespace vct::gl
