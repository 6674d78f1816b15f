// Creates GL contexts without a window. One interface for three back ends: EGL, OSMesa and zink.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/capabilities.h"

namespace vct {

enum class Backend {
    egl,     // EGL without a surface, ES 3.1 or later, on the driver that EGL finds
    osmesa,  // Mesa's off-screen library, desktop 4.5 core context (it has no ES), loaded at run time
    zink,    // EGL as above, on Mesa's GL over Vulkan (lavapipe without a GPU)
};

Backend backendFromName(const std::string& name);  // throws vct::Error that lists the names
const char* backendName(Backend backend);

// A current GL context. Destruction releases it.
class Platform {
  public:
    using Proc = void (*)();

    virtual ~Platform() = default;
    virtual Proc getProcAddress(const char* name) const = 0;
    virtual std::string description() const = 0;  // "EGL 1.5 surfaceless (Mesa Project)"
};

struct PlatformOptions {
    Backend backend = Backend::egl;
    int device = -1;     // index into eglDevices(), or -1: the driver's default
    bool debug = false;  // ask for a debug context
};

// Creates a context and makes it current on the calling thread. Throws vct::Error with cause and remedy.
std::unique_ptr<Platform> createPlatform(const PlatformOptions& options);

// A context that is ready for rendering: entry points are loaded, the debug callback is installed, and the
// capabilities are queried.
struct Context {
    std::unique_ptr<Platform> platform;
    gl::Capabilities capabilities;
};

// Throws vct::Error if there is no context. Missing features of the driver are listed in the capabilities.
Context openContext(Backend backend, int device = -1);

// Names of the EGL devices by index; empty if EGL cannot enumerate them.
std::vector<std::string> eglDevices();

}  // namespace vct
