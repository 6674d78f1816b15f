// EGL without a window system: Mesa's surfaceless platform, else a device (NVIDIA's way), else the default
// display.
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <map>
#include <utility>

#include "core/error.h"
#include "platform/backends.h"

namespace vct {
namespace {

std::string eglError() {
    switch (const EGLint error = eglGetError()) {
        case EGL_SUCCESS:
            return "EGL_SUCCESS";
        case EGL_NOT_INITIALIZED:
            return "EGL_NOT_INITIALIZED";
        case EGL_BAD_ACCESS:
            return "EGL_BAD_ACCESS";
        case EGL_BAD_ALLOC:
            return "EGL_BAD_ALLOC";
        case EGL_BAD_ATTRIBUTE:
            return "EGL_BAD_ATTRIBUTE";
        case EGL_BAD_CONFIG:
            return "EGL_BAD_CONFIG";
        case EGL_BAD_DISPLAY:
            return "EGL_BAD_DISPLAY";
        case EGL_BAD_MATCH:
            return "EGL_BAD_MATCH";
        case EGL_BAD_PARAMETER:
            return "EGL_BAD_PARAMETER";
        default:
            return "EGL error " + std::to_string(error);
    }
}

std::string queryString(EGLDisplay display, EGLint name) {
    const char* text = eglQueryString(display, name);
    return text ? text : "";
}

bool contains(const std::string& extensions, const std::string& name) {
    return (" " + extensions + " ").find(" " + name + " ") != std::string::npos;
}

// Where the extension is missing, EGL 1.4 answers with a null string and an error that must not linger.
std::string clientExtensions() {
    const std::string extensions = queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    eglGetError();
    return extensions;
}

template <typename Function>
Function eglProc(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::vector<EGLDeviceEXT> devices() {
    const std::string extensions = clientExtensions();
    if (!contains(extensions, "EGL_EXT_device_base") && !contains(extensions, "EGL_EXT_device_enumeration"))
        return {};
    const auto queryDevices = eglProc<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (!queryDevices || !queryDevices(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> found(static_cast<size_t>(count));
    if (!queryDevices(count, found.data(), &count)) return {};
    found.resize(static_cast<size_t>(count));
    return found;
}

std::string deviceName(EGLDeviceEXT device) {
    const auto query = eglProc<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    if (!query) return "unnamed";
    const auto string = [&](EGLint name) {
        const char* text = query(device, name);
        return std::string(text ? text : "");
    };
    const std::string extensions = string(EGL_EXTENSIONS);
    std::string name;
    if (contains(extensions, "EGL_EXT_device_query_name")) name = string(EGL_RENDERER_EXT);
    if (name.empty() && contains(extensions, "EGL_MESA_device_software")) name = "Mesa software rasterizer";
    if (contains(extensions, "EGL_EXT_device_drm")) {
        const std::string node = string(EGL_DRM_DEVICE_FILE_EXT);
        name += (name.empty() ? "" : ", ") + node;
    }
    return name.empty() ? "unnamed (" + extensions + ")" : name;
}

// A display is one per process and native platform, so whoever leaves last terminates it.
std::map<EGLDisplay, int>& displayUsers() {
    static std::map<EGLDisplay, int> users;
    return users;
}

// One place where a display can come from.
struct Source {
    std::string name;
    EGLenum platform = EGL_NONE;  // none: eglGetDisplay
    void* native = nullptr;
};

std::vector<Source> sources(int device) {
    const std::vector<EGLDeviceEXT> found = devices();
    std::vector<Source> result;
    if (device >= 0) {
        if (static_cast<size_t>(device) >= found.size())
            throw Error("EGL has no device " + std::to_string(device) + ", it lists " +
                        std::to_string(found.size()) + "; `vct info --list-devices` names them");
        const auto native = found[static_cast<size_t>(device)];
        return {{"device " + std::to_string(device), EGL_PLATFORM_DEVICE_EXT, native}};
    }
    const std::string extensions = clientExtensions();
    if (contains(extensions, "EGL_MESA_platform_surfaceless"))
        result.push_back({"surfaceless", EGL_PLATFORM_SURFACELESS_MESA, nullptr});
    if (contains(extensions, "EGL_EXT_platform_device")) {
        for (size_t i = 0; i < found.size(); ++i)
            result.push_back({"device " + std::to_string(i), EGL_PLATFORM_DEVICE_EXT, found[i]});
    }
    result.push_back({"default display", EGL_NONE, nullptr});
    return result;
}

class EglPlatform : public Platform {
  public:
    EglPlatform(const Source& source, bool debug) {
        openDisplay(source);
        try {
            createContext(debug);
        } catch (...) {
            release();
            throw;
        }
    }
    ~EglPlatform() override { release(); }
    EglPlatform(const EglPlatform&) = delete;
    EglPlatform& operator=(const EglPlatform&) = delete;

    Proc getProcAddress(const char* name) const override { return eglGetProcAddress(name); }
    std::string description() const override { return description_; }

  private:
    void openDisplay(const Source& source) {
        if (source.platform == EGL_NONE) {
            display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
        } else {
            const auto getDisplay = eglProc<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
            if (!getDisplay) throw Error("EGL has no eglGetPlatformDisplayEXT");
            display_ = getDisplay(source.platform, source.native, nullptr);
        }
        if (display_ == EGL_NO_DISPLAY) throw Error("no display, " + eglError());
        EGLint major = 0, minor = 0;
        if (!eglInitialize(display_, &major, &minor)) throw Error("eglInitialize failed, " + eglError());
        ++displayUsers()[display_];
        version_ = {major, minor};
        extensions_ = queryString(display_, EGL_EXTENSIONS);
        description_ = "EGL " + std::to_string(major) + "." + std::to_string(minor) + " " + source.name +
                       " (" + queryString(display_, EGL_VENDOR) + ")";
    }

    void createContext(bool debug) {
        if (!eglBindAPI(EGL_OPENGL_ES_API)) throw Error("no OpenGL ES, " + eglError());
        const bool surfaceless = contains(extensions_, "EGL_KHR_surfaceless_context");
        const EGLConfig config = chooseConfig(surfaceless);
        if (!surfaceless) {
            const std::array<EGLint, 5> pbufferAttribs = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface_ = eglCreatePbufferSurface(display_, config, pbufferAttribs.data());
            if (surface_ == EGL_NO_SURFACE) throw Error("no 1x1 pbuffer, " + eglError());
        }
        // Some drivers give the version that is asked for and no more.
        for (const EGLint minor : {2, 1}) {
            if (context_ == EGL_NO_CONTEXT) context_ = tryContext(config, minor, debug);
        }
        if (context_ == EGL_NO_CONTEXT) throw Error("no OpenGL ES 3.1 context, " + eglError());
        if (!eglMakeCurrent(display_, surface_, surface_, context_))
            throw Error("eglMakeCurrent failed, " + eglError());
    }

    EGLConfig chooseConfig(bool surfaceless) const {
        // The default asks for a window; without a surface any configuration will do.
        const std::array<EGLint, 5> attribs = {EGL_SURFACE_TYPE, surfaceless ? 0 : EGL_PBUFFER_BIT,
                                               EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglChooseConfig(display_, attribs.data(), &config, 1, &count) && count > 0) return config;
        if (surfaceless && contains(extensions_, "EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
        throw Error("no configuration for OpenGL ES 3, " + eglError());
    }

    EGLContext tryContext(EGLConfig config, EGLint minor, bool debug) const {
        std::vector<EGLint> attribs = {EGL_CONTEXT_CLIENT_VERSION, 3};
        const bool core15 = version_ >= std::pair{1, 5};
        const bool createContextExtension = contains(extensions_, "EGL_KHR_create_context");
        if (core15 || createContextExtension)
            attribs.insert(attribs.end(), {EGL_CONTEXT_MINOR_VERSION, minor});
        if (debug && core15)
            attribs.insert(attribs.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
        else if (debug && createContextExtension)
            attribs.insert(attribs.end(), {EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR});
        attribs.push_back(EGL_NONE);
        return eglCreateContext(display_, config, EGL_NO_CONTEXT, attribs.data());
    }

    void release() {
        if (context_ != EGL_NO_CONTEXT) {
            if (eglGetCurrentContext() == context_)
                eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display_, context_);
        }
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
        if (--displayUsers()[display_] > 0) return;
        displayUsers().erase(display_);
        eglTerminate(display_);
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
    std::pair<EGLint, EGLint> version_;
    std::string extensions_, description_;
};

}  // namespace

std::vector<std::string> eglDevices() {
    std::vector<std::string> names;
    for (const EGLDeviceEXT device : devices())
        names.push_back(deviceName(device));
    return names;
}

bool detail::eglInUse() {
    return !displayUsers().empty();
}

std::unique_ptr<Platform> detail::createEgl(const PlatformOptions& options) {
    std::string failures;
    for (const Source& source : sources(options.device)) {
        try {
            return std::make_unique<EglPlatform>(source, options.debug);
        } catch (const Error& error) {
            failures += (failures.empty() ? "" : "; ") + source.name + ": " + error.what();
        }
    }
    throw Error("EGL gives no OpenGL ES 3.1 context (" + failures +
                "); install a driver (libegl1 and libgl1-mesa-dri for Mesa's)");
}

}  // namespace vct
