// Time that the GPU itself measures: GL_EXT_disjoint_timer_query.
#pragma once

#include "gl/objects.h"

namespace vct::gl {

// Bits of the GPU's clock; 0 where it has none. Only on a context with the extension.
int gpuTimerBits();

// True where the GPU's clock jumped since the last call (a change of frequency, another app): what was
// measured meanwhile means nothing.
bool gpuTimerWasDisjoint();

// One query at a time. Only where gpuTimerBits() > 0.
class GpuTimer {
  public:
    void begin();
    void stop();
    // Waits for the GPU. Milliseconds from begin() to stop().
    double resultMs() const;

  private:
    Handle<&DeleteQueries> handle_{generate(GenQueries)};
};

}  // namespace vct::gl
