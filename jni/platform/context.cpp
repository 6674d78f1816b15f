#include "platform/context.h"

#include "core/memory.h"
#include "gl/api.h"
#include "gl/debug.h"

namespace vct {

Context openContext(Backend backend, int device) {
    PlatformOptions options;
    options.backend = backend;
    options.device = device;
    options.debug = VCT_GL_DEBUG != 0;
    Context context;
    context.platform = createPlatform(options);
    gl::load([](const char* name,
                const void* user) { return static_cast<const Platform*>(user)->getProcAddress(name); },
             context.platform.get());
    if (options.debug) gl::installDebugCallback();
    context.capabilities = gl::queryCapabilities();
    if (context.capabilities.softwareDriver) requireMemory(0, context.capabilities.renderer);
    return context;
}

}  // namespace vct
