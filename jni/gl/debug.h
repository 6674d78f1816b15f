// KHR_debug: errors become exceptions, and passes become named groups in RenderDoc, AGI and apitrace.
#pragma once

#include <string>

#include "core/error.h"
#include "core/trace.h"

namespace vct::gl {

// Installs the debug callback on the current context (a no-op without KHR_debug). Errors and high-severity
// messages are kept until checkErrors(); the rest is dropped.
void installDebugCallback();

// The context is gone with everything in it, as on a phone whose GPU was reset: it must be made anew.
class ContextLost : public Error {
  public:
    using Error::Error;
};

// Throws ContextLost where the driver says so. Throws vct::Error with every message kept since the last call,
// or with glGetError's where there is no KHR_debug. `where` names the pass.
void checkErrors(const std::string& where);

// A named group for as long as it lives, also on the timeline of core/trace.h.
class DebugGroup {
  public:
    explicit DebugGroup(const char* name);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;

  private:
    TraceSection section_;
};

// Names a GL object for debuggers. `identifier` is GL_TEXTURE, GL_BUFFER, ...
void label(unsigned identifier, unsigned name, const std::string& text);

}  // namespace vct::gl
