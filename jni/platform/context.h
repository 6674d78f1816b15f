// A context that is ready to be rendered with: created, entry points loaded, debug callback on, capabilities
// asked.
#pragma once

#include <memory>

#include "gl/capabilities.h"
#include "platform/platform.h"

namespace vct {

struct Context {
    std::unique_ptr<Platform> platform;
    gl::Capabilities capabilities;
};

// Throws vct::Error where there is no context; what the driver lacks is in the capabilities.
Context openContext(Backend backend, int device = -1);

}  // namespace vct
