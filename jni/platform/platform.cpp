#include "platform/platform.h"

#include "core/error.h"
#include "platform/backends.h"

namespace vct {
namespace {

constexpr Backend allBackends[] = {Backend::egl, Backend::osmesa, Backend::zink};

}  // namespace

const char* backendName(Backend backend) {
    switch (backend) {
        case Backend::egl:
            return "egl";
        case Backend::osmesa:
            return "osmesa";
        case Backend::zink:
            return "zink";
    }
    return "unknown";
}

Backend backendFromName(const std::string& name) {
    std::string names;
    for (const Backend backend : allBackends) {
        if (name == backendName(backend)) return backend;
        names += (names.empty() ? "" : ", ") + std::string(backendName(backend));
    }
    throw Error("there is no back end named '" + name + "'; choose one of " + names);
}

std::unique_ptr<Platform> createPlatform(const PlatformOptions& options) {
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

std::string detail::rendererOf(const Platform& platform) {
    constexpr unsigned glRenderer = 0x1F01;
    using GetString = const unsigned char* (*)(unsigned);
    const auto getString = reinterpret_cast<GetString>(platform.getProcAddress("glGetString"));
    const unsigned char* text = getString ? getString(glRenderer) : nullptr;
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace vct
