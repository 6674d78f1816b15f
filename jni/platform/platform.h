// Where a GL context comes from. One small interface; EGL surfaceless, OSMesa and zink stand behind it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/capabilities.h"

namespace vct {

enum class Backend {
    egl,     // EGL without a surface, ES 3.1 or later, on whatever driver EGL finds
    osmesa,  // Mesa's off-screen library, desktop 4.5 core context (it has no ES), loaded at run time
    zink,    // EGL as above, on Mesa's GL over Vulkan (lavapipe where there is no GPU)
};

Backend backendFromName(const std::string& name);  // throws vct::Error listing the names
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

// Creates a context and makes it current on the calling thread; throws vct::Error with cause and remedy.
std::unique_ptr<Platform> createPlatform(const PlatformOptions& options);

// A context that is ready to be rendered with: created, entry points loaded, debug callback on, capabilities
// asked.
struct Context {
    std::unique_ptr<Platform> platform;
    gl::Capabilities capabilities;
};

// Throws vct::Error where there is no context; what the driver lacks is in the capabilities.
Context openContext(Backend backend, int device = -1);

// Names of the EGL devices, in the order of their indices; empty where EGL cannot enumerate.
std::vector<std::string> eglDevices();

}  // namespace vct
