// Contexts for tests that run on every back end.
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <memory>
#include <string>

#include "gl/api.h"
#include "platform/platform.h"

namespace vct::test {

inline bool libraryExists(const char* name) {
    void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    return handle != nullptr;  // left open: OSMesa does not survive being closed
}

// The reason why the back end is not on this machine, or "". It does not use the code under test, so that a
// back end which is installed and does not start fails its tests.
inline std::string whyAbsent(Backend backend) {
    if (backend == Backend::osmesa) {
        for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
            if (libraryExists(name)) return "";
        }
        return "OSMesa is not installed (package libosmesa6)";
    }
    if (backend == Backend::zink) {
        if (!libraryExists("libvulkan.so.1")) return "there is no Vulkan loader (package libvulkan1)";
        std::error_code error;
        const std::filesystem::directory_iterator drivers("/usr/share/vulkan/icd.d", error);
        if (error || drivers == std::filesystem::directory_iterator())
            return "there is no Vulkan driver for zink (package mesa-vulkan-drivers)";
    }
    return "";
}

inline std::unique_ptr<Platform> createContext(Backend backend, bool debug = true) {
    PlatformOptions options;
    options.backend = backend;
    options.debug = debug;
    std::unique_ptr<Platform> platform = createPlatform(options);
    gl::load([](const char* name,
                const void* user) { return static_cast<const Platform*>(user)->getProcAddress(name); },
             platform.get());
    return platform;
}

}  // namespace vct::test

// For the body of a test, as skipping leaves the function.
#define VCT_SKIP_IF_ABSENT(backend)                               \
    do {                                                          \
        const std::string reason = vct::test::whyAbsent(backend); \
        if (!reason.empty()) GTEST_SKIP() << reason;              \
    } while (false)
