#include "platform/platform.h"

#include <cstddef>
#include <iterator>

#include "core/error.h"
#include "core/memory.h"
#include "gl/api.h"
#include "gl/debug.h"
#include "platform/backends.h"

namespace vct {
namespace {

constexpr const char* backendNames[] = {"egl", "osmesa", "zink"};  // by value of Backend

}  // namespace

const char* backendName(Backend backend) {
    return backendNames[static_cast<std::size_t>(backend)];
}

Backend backendFromName(const std::string& name) {
    std::string names;
    for (std::size_t i = 0; i < std::size(backendNames); ++i) {
        if (name == backendNames[i]) return static_cast<Backend>(i);
        names += (names.empty() ? "" : ", ") + std::string(backendNames[i]);
    }
    throw Error("there is no back end named '" + name + "'; choose one of " + names);
}

std::unique_ptr<Platform> createPlatform(const PlatformOptions& options) {
    requireDriver();
    switch (options.backend) {
        case Backend::egl:
            return detail::createEgl(options, "; install a driver (libegl1 and libgl1-mesa-dri for Mesa's)");
        case Backend::osmesa:
            return detail::createOsmesa(options);
        case Backend::zink:
            return detail::createZink(options);
    }
    throw Error("unknown back end " + std::to_string(static_cast<int>(options.backend)));
}

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
