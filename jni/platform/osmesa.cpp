// GL contexts by OSMesa, which renders into main memory and has no displays and devices. Mesa 25.1 and later
// do not include it, so it is loaded at run time and nothing links to it.
#include <dlfcn.h>

#include <array>
#include <vector>

#include "core/error.h"
#include "platform/backends.h"

namespace vct::detail {
namespace {

// Copied from GL/osmesa.h, which is not installed everywhere and includes desktop GL headers.
using OsmesaContext = struct osmesa_context*;
enum : int {
    osmesaProfile = 0x33,
    osmesaCoreProfile = 0x34,
    osmesaContextMajorVersion = 0x36,
    osmesaContextMinorVersion = 0x37,
};
constexpr unsigned glUnsignedByte = 0x1401;

struct Library {
    std::string name;
    OsmesaContext (*createContextAttribs)(const int* attribs, OsmesaContext share) = nullptr;
    void (*destroyContext)(OsmesaContext) = nullptr;
    unsigned char (*makeCurrent)(OsmesaContext, void* buffer, unsigned type, int width, int height) = nullptr;
    OsmesaContext (*getCurrentContext)() = nullptr;
    Platform::Proc (*getProcAddress)(const char*) = nullptr;
};

template <typename Function>
void resolve(void* handle, const char* name, const std::string& library, Function& function) {
    function = reinterpret_cast<Function>(dlsym(handle, name));
    if (!function)
        throw Error(library + " has no " + name +
                    "; install libosmesa6 of Mesa 17 or later, or use the back end egl");
}

// Loads the library. RTLD_LOCAL keeps its GL symbols from replacing those of libEGL. The library is never
// closed, because its dependencies LLVM and glapi register thread-local destructors, which must not be
// unloaded.
Library openLibrary() {
    constexpr std::array names = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    std::string reasons;
    for (const char* name : names) {
        void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            const char* reason = dlerror();
            reasons += std::string(reasons.empty() ? "" : "; ") + (reason ? reason : name);
            continue;
        }
        Library library;
        library.name = name;
        resolve(handle, "OSMesaCreateContextAttribs", name, library.createContextAttribs);
        resolve(handle, "OSMesaDestroyContext", name, library.destroyContext);
        resolve(handle, "OSMesaMakeCurrent", name, library.makeCurrent);
        resolve(handle, "OSMesaGetCurrentContext", name, library.getCurrentContext);
        resolve(handle, "OSMesaGetProcAddress", name, library.getProcAddress);
        return library;
    }
    throw Error("OSMesa cannot be loaded (" + reasons + "); install libosmesa6, or use the back end egl");
}

class OsmesaPlatform : public Platform {
  public:
    OsmesaPlatform() : library_(openLibrary()) {
        // Other attributes have their defaults: RGBA, no depth, stencil and accumulation buffers.
        const int attribs[] = {
            osmesaProfile, osmesaCoreProfile, osmesaContextMajorVersion, 4, osmesaContextMinorVersion, 5, 0};
        context_ = library_.createContextAttribs(attribs, nullptr);
        if (!context_)
            throw Error(
                library_.name +
                " cannot create an OpenGL 4.5 core context; install Mesa 20.2 or later with llvmpipe, "
                "or use the back end egl");
        if (!library_.makeCurrent(context_, buffer_.data(), glUnsignedByte, width, height)) {
            library_.destroyContext(context_);
            throw Error(library_.name + " cannot make its context current; use the back end egl");
        }
    }

    ~OsmesaPlatform() override {
        if (library_.getCurrentContext() == context_) library_.makeCurrent(nullptr, nullptr, 0, 0, 0);
        library_.destroyContext(context_);
    }

    OsmesaPlatform(const OsmesaPlatform&) = delete;
    OsmesaPlatform& operator=(const OsmesaPlatform&) = delete;

    Proc getProcAddress(const char* name) const override { return library_.getProcAddress(name); }
    std::string description() const override {
        return "OSMesa (" + library_.name + "), desktop core context";
    }

  private:
    // OSMesa needs a default framebuffer, although every pass draws into its own.
    static constexpr int width = 16, height = 16;

    Library library_;
    OsmesaContext context_ = nullptr;
    std::vector<unsigned char> buffer_ = std::vector<unsigned char>(width * height * 4);
};

}  // namespace

std::unique_ptr<Platform> createOsmesa(const PlatformOptions& options) {
    if (options.device >= 0) throw Error("OSMesa renders on the CPU and has no devices; choose no device");
    return std::make_unique<OsmesaPlatform>();
}

}  // namespace vct::detail
