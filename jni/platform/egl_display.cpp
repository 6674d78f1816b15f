#include "platform/egl_display.h"

#include "core/error.h"
#include "platform/platform.h"

namespace vct {
namespace detail {

std::string eglString(EGLDisplay display, EGLint name) {
    const char* text = eglQueryString(display, name);
    return text ? text : "";
}

bool containsWord(const std::string& extensions, const std::string& name) {
    return (" " + extensions + " ").find(" " + name + " ") != std::string::npos;
}

}  // namespace detail

namespace {

using detail::containsWord;
using detail::eglString;

// Where the extension is missing, EGL 1.4 answers with a null string and an error that must not linger.
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

}  // namespace

namespace detail {

std::vector<EglSource> eglSources(int device) {
    const std::vector<EGLDeviceEXT> found = devices();
    std::vector<EglSource> result;
    if (device >= 0) {
        if (static_cast<size_t>(device) >= found.size())
            throw Error("EGL has no device " + std::to_string(device) + ", it lists " +
                        std::to_string(found.size()) + "; `vct info --list-devices` names them");
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

}  // namespace detail

std::vector<std::string> eglDevices() {
    std::vector<std::string> names;
    for (const EGLDeviceEXT device : devices())
        names.push_back(deviceName(device));
    return names;
}

}  // namespace vct
