// Error reports and names for debuggers through KHR_debug. Errors become exceptions, and passes become named
// groups in RenderDoc, AGI and apitrace.
#pragma once

#include <string>

#include "core/error.h"
#include "core/trace.h"

namespace vct::gl {

// Installs the debug callback on the current context, if it has KHR_debug. Errors and messages of high
// severity are kept until checkErrors(); others are dropped.
void installDebugCallback();

// The context is lost with all its objects, for example by a GPU reset on a phone. The caller has to create
// another context and renderer.
class ContextLost : public Error {
  public:
    using Error::Error;
};

// Throws ContextLost if the context is lost. Throws vct::Error with all messages kept by the debug callback,
// or with the errors of glGetError() if there are no messages. `where` names the pass.
void checkErrors(const std::string& where);

// A named debug group for the lifetime of the object. It is also a section on the timeline of core/trace.h.
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
