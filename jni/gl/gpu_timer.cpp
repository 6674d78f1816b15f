#include "gl/gpu_timer.h"

namespace vct::gl {

int gpuTimerBits() {
    if (GetQueryObjectui64v == nullptr) return 0;
    GLint bits = 0;
    GetQueryiv(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
    return bits;
}

bool gpuTimerWasDisjoint() {
    GLint disjoint = 0;
    GetIntegerv(GL_GPU_DISJOINT_EXT, &disjoint);
    return disjoint != 0;
}

void GpuTimer::begin() {
    BeginQuery(GL_TIME_ELAPSED_EXT, handle_.get());
}

void GpuTimer::stop() {
    EndQuery(GL_TIME_ELAPSED_EXT);
}

double GpuTimer::resultMs() const {
    GLuint64 nanoseconds = 0;
    GetQueryObjectui64v(handle_.get(), GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) * 1e-6;
}

}  // namespace vct::gl
