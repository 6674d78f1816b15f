// GL contexts by EGL without a window system. Displays are tried in this order: Mesa's surfaceless platform,
// a device (as NVIDIA's driver has it), the default display.
#include "platform/egl_error.h"

#include <EGL/eglext.h>

#include <array>
#include <map>
#include <utility>

#include "core/error.h"
#include "platform/backends.h"

namespace vct::detail {
namespace {

// Returns the name of the last error, and clears it.
std::string eglError() {
    return eglErrorName(eglGetError());
}

std::string eglString(EGLDisplay display, EGLint name) {
    const char* text = eglQueryString(display, name);
    return text ? text : "";
}

bool containsWord(const std::string& words, const std::string& word) {
    return (" " + words + " ").find(" " + word + " ") != std::string::npos;
}

// Without client extensions EGL 1.4 returns a null string and sets an error, which is cleared here.
std::string clientExtensions() {
    const std::string extensions = eglString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    eglGetError();
    return extensions;
}

template <typename Function>
Function eglProc(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::vector<EGLDeviceEXT> devices() {
    const std::string extensions = clientExtensions();
    if (!containsWord(extensions, "EGL_EXT_device_base") &&
        !containsWord(extensions, "EGL_EXT_device_enumeration"))
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
    if (containsWord(extensions, "EGL_EXT_device_query_name")) name = string(EGL_RENDERER_EXT);
    if (name.empty() && containsWord(extensions, "EGL_MESA_device_software"))
        name = "Mesa software rasterizer";
    if (containsWord(extensions, "EGL_EXT_device_drm")) {
        const std::string node = string(EGL_DRM_DEVICE_FILE_EXT);
        name += (name.empty() ? "" : ", ") + node;
    }
    return name.empty() ? "unnamed (" + extensions + ")" : name;
}

// A way to get a display.
struct EglSource {
    std::string name;
    EGLenum platform = EGL_NONE;  // EGL_NONE: by eglGetDisplay()
    void* native = nullptr;
};

// The sources in the order in which to try them; only the device with this index if it is not -1.
std::vector<EglSource> eglSources(int device) {
    const std::vector<EGLDeviceEXT> found = devices();
    std::vector<EglSource> result;
    if (device >= 0) {
        if (static_cast<size_t>(device) >= found.size())
            throw Error("EGL has no device " + std::to_string(device) + ", only " +
                        std::to_string(found.size()) + " devices; `vct info --list-devices` lists them");
        const auto native = found[static_cast<size_t>(device)];
        return {{"device " + std::to_string(device), EGL_PLATFORM_DEVICE_EXT, native}};
    }
    const std::string extensions = clientExtensions();
    if (containsWord(extensions, "EGL_MESA_platform_surfaceless"))
        result.push_back({"surfaceless", EGL_PLATFORM_SURFACELESS_MESA, nullptr});
    if (containsWord(extensions, "EGL_EXT_platform_device")) {
        for (size_t i = 0; i < found.size(); ++i)
            result.push_back({"device " + std::to_string(i), EGL_PLATFORM_DEVICE_EXT, found[i]});
    }
    result.push_back({"default display", EGL_NONE, nullptr});
    return result;
}

// Throws vct::Error if the source has no display.
EGLDisplay openEglDisplay(const EglSource& source) {
    EGLDisplay display = EGL_NO_DISPLAY;
    if (source.platform == EGL_NONE) {
        display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    } else {
        const auto getDisplay = eglProc<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        if (!getDisplay) throw Error("EGL has no eglGetPlatformDisplayEXT");
        display = getDisplay(source.platform, source.native, nullptr);
    }
    if (display == EGL_NO_DISPLAY) throw Error("no display, " + eglError());
    return display;
}

// The number of users of each display. A process has one display per native platform, and the last user
// terminates it.
std::map<EGLDisplay, int>& displayUsers() {
    static std::map<EGLDisplay, int> users;
    return users;
}

// Thrown if a display has a driver, but of an older version.
class OldDriver : public Error {
  public:
    using Error::Error;
};

class EglPlatform : public Platform {
  public:
    EglPlatform(const EglSource& source, bool debug) {
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
    void openDisplay(const EglSource& source) {
        display_ = openEglDisplay(source);
        EGLint major = 0, minor = 0;
        if (!eglInitialize(display_, &major, &minor)) throw Error("eglInitialize failed, " + eglError());
        ++displayUsers()[display_];
        version_ = {major, minor};
        extensions_ = eglString(display_, EGL_EXTENSIONS);
        description_ = "EGL " + std::to_string(major) + "." + std::to_string(minor) + " " + source.name +
                       " (" + eglString(display_, EGL_VENDOR) + ")";
    }

    void createContext(bool debug) {
        if (!eglBindAPI(EGL_OPENGL_ES_API)) throw Error("no OpenGL ES, " + eglError());
        const bool surfaceless = containsWord(extensions_, "EGL_KHR_surfaceless_context");
        const EGLConfig config = chooseConfig(surfaceless);
        if (!surfaceless) {
            const std::array<EGLint, 5> pbufferAttribs = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface_ = eglCreatePbufferSurface(display_, config, pbufferAttribs.data());
            if (surface_ == EGL_NO_SURFACE) throw Error("no 1x1 pbuffer, " + eglError());
        }
        // Some drivers return exactly the requested version, so 3.2 is tried before 3.1. Some have no debug
        // contexts.
        for (const EGLint minor : {2, 1}) {
            for (const bool askDebug : {debug, false}) {
                if (context_ == EGL_NO_CONTEXT) context_ = tryContext(config, minor, askDebug);
            }
        }
        if (context_ == EGL_NO_CONTEXT) {
            const std::string error = eglError();
            const std::string older = olderDriver(config);
            if (!older.empty()) throw OldDriver("the driver " + older + " is too old");
            throw Error("no OpenGL ES 3.1 context, " + error);
        }
        if (!eglMakeCurrent(display_, surface_, surface_, context_))
            throw Error("eglMakeCurrent failed, " + eglError());
    }

    EGLConfig chooseConfig(bool surfaceless) const {
        // The default of EGL_SURFACE_TYPE is a window. Without a surface any configuration works.
        const std::array<EGLint, 5> attribs = {EGL_SURFACE_TYPE, surfaceless ? 0 : EGL_PBUFFER_BIT,
                                               EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglChooseConfig(display_, attribs.data(), &config, 1, &count) && count > 0) return config;
        if (surfaceless && containsWord(extensions_, "EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
        throw Error("no configuration for OpenGL ES 3, " + eglError());
    }

    EGLContext tryContext(EGLConfig config, EGLint minor, bool debug) const {
        std::vector<EGLint> attribs = {EGL_CONTEXT_CLIENT_VERSION, 3};
        const bool core15 = version_ >= std::pair{1, 5};
        const bool createContextExtension = containsWord(extensions_, "EGL_KHR_create_context");
        if (core15 || createContextExtension)
            attribs.insert(attribs.end(), {EGL_CONTEXT_MINOR_VERSION, minor});
        if (debug && core15)
            attribs.insert(attribs.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
        else if (debug && createContextExtension)
            attribs.insert(attribs.end(), {EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR});
        attribs.push_back(EGL_NONE);
        return eglCreateContext(display_, config, EGL_NO_CONTEXT, attribs.data());
    }

    // Names the driver and its version if it gives contexts of older versions; returns "" if it gives none.
    std::string olderDriver(EGLConfig config) {
        for (const EGLint major : {3, 2}) {
            const std::array<EGLint, 3> attribs = {EGL_CONTEXT_CLIENT_VERSION, major, EGL_NONE};
            const EGLContext older = eglCreateContext(display_, config, EGL_NO_CONTEXT, attribs.data());
            if (older == EGL_NO_CONTEXT) continue;
            std::string name;
            if (eglMakeCurrent(display_, surface_, surface_, older)) {
                const auto getString =
                    reinterpret_cast<const unsigned char* (*)(unsigned)>(eglGetProcAddress("glGetString"));
                constexpr unsigned glRenderer = 0x1F01, glVersion = 0x1F02;
                for (const unsigned key : {glRenderer, glVersion}) {
                    const unsigned char* const text = getString ? getString(key) : nullptr;
                    if (text)
                        name += (name.empty() ? "" : ", ") + std::string(reinterpret_cast<const char*>(text));
                }
                eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            }
            eglDestroyContext(display_, older);
            if (!name.empty()) return name;
        }
        return "";
    }

    void release() {
        if (context_ != EGL_NO_CONTEXT) {
            // The GPU must be idle when the context is destroyed, because zink on lavapipe of Mesa 25 can
            // crash otherwise.
            if (eglGetCurrentContext() == context_) {
                if (const auto finish = eglGetProcAddress("glFinish")) finish();
                eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            }
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

bool eglInUse() {
    return !displayUsers().empty();
}

std::unique_ptr<Platform> createEgl(const PlatformOptions& options, const std::string& remedy) {
    std::string failures;
    bool isOld = false;
    for (const EglSource& source : eglSources(options.device)) {
        std::string failure;
        try {
            return std::make_unique<EglPlatform>(source, options.debug);
        } catch (const OldDriver& error) {
            isOld = true;
            failure = error.what();
        } catch (const Error& error) {
            failure = error.what();
        }
        failures += (failures.empty() ? "" : "; ") + source.name + ": " + failure;
    }
    throw Error("EGL cannot create an OpenGL ES 3.1 context (" + failures + ")" +
                (isOld && !remedy.empty() ? "; update the driver, or choose another back end" : remedy));
}

}  // namespace vct::detail

namespace vct {

std::vector<std::string> eglDevices() {
    std::vector<std::string> names;
    for (const EGLDeviceEXT device : detail::devices())
        names.push_back(detail::deviceName(device));
    return names;
}

}  // namespace vct
