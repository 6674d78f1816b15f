// GL contexts by zink, Mesa's OpenGL over Vulkan. EGL cannot select it: Mesa chooses the driver by
// environment variables, which it reads when the display is initialised.
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.h"
#include "platform/backends.h"

namespace vct::detail {
namespace {

namespace fs = std::filesystem;

// Sets environment variables during its lifetime, so that EGL contexts created later do not use zink. As with
// setenv(), no other thread may read the environment meanwhile.
class ScopedEnvironment {
  public:
    ScopedEnvironment() = default;
    ~ScopedEnvironment() {
        for (auto it = saved_.rbegin(); it != saved_.rend(); ++it) {
            if (it->second)
                setenv(it->first.c_str(), it->second->c_str(), 1);
            else
                unsetenv(it->first.c_str());
        }
    }
    ScopedEnvironment(const ScopedEnvironment&) = delete;
    ScopedEnvironment& operator=(const ScopedEnvironment&) = delete;

    void set(const char* name, const std::string& value) {
        const char* old = std::getenv(name);
        saved_.emplace_back(name, old ? std::optional<std::string>(old) : std::nullopt);
        setenv(name, value.c_str(), 1);
    }
    void setIfUnset(const char* name, const std::string& value) {
        if (!std::getenv(name)) set(name, value);
    }

  private:
    std::vector<std::pair<std::string, std::optional<std::string>>> saved_;
};

// The path of a file in the folder whose name begins with `start`; empty if there is none.
std::string fileThatBegins(const char* folder, const std::string& start) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().filename().string().rfind(start, 0) == 0) return entry.path().string();
    return "";
}

// The Vulkan loader's file for lavapipe, Mesa's Vulkan on the CPU; empty if it is not installed.
std::string lavapipeIcd() {
    for (const char* folder :
         {"/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/etc/vulkan/icd.d"})
        if (const std::string icd = fileThatBegins(folder, "lvp_icd."); !icd.empty()) return icd;
    return "";
}

// GL_RENDERER of the current context, before its entry points are loaded.
std::string rendererOf(const Platform& platform) {
    constexpr unsigned glRenderer = 0x1F01;
    using GetString = const unsigned char* (*)(unsigned);
    const auto getString = reinterpret_cast<GetString>(platform.getProcAddress("glGetString"));
    const unsigned char* text = getString ? getString(glRenderer) : nullptr;
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

// Returns null and adds the reason to `failures` if the context is not zink's.
std::unique_ptr<Platform> tryZink(const PlatformOptions& options, bool software, std::string& failures) {
    ScopedEnvironment environment;
    environment.set("GALLIUM_DRIVER", "zink");
    environment.set("MESA_LOADER_DRIVER_OVERRIDE", "zink");
    // lavapipe asks libwayland for a compositor, which prints a warning if this is unset. With a folder that
    // does not exist there is no compositor either, but no warning.
    environment.setIfUnset("XDG_RUNTIME_DIR", "/nonexistent");
    if (software) {
        environment.set("LIBGL_ALWAYS_SOFTWARE", "1");
        // Without this the loader also opens drivers of absent GPUs, and may prefer one of them.
        const bool chosenByUser = std::getenv("VK_ICD_FILENAMES") || std::getenv("VK_DRIVER_FILES");
        const std::string icd = chosenByUser ? "" : lavapipeIcd();
        if (!icd.empty()) {
            environment.set("VK_ICD_FILENAMES", icd);
            environment.set("VK_DRIVER_FILES", icd);
        }
    }
    const std::string attempt = software ? "on lavapipe: " : "on the GPU's Vulkan driver: ";
    try {
        std::unique_ptr<Platform> platform = createEgl(options, "");
        const std::string renderer = rendererOf(*platform);
        if (renderer.find("zink") != std::string::npos) return platform;
        failures += (failures.empty() ? "" : "; ") + attempt + "EGL gave '" + renderer + "' instead";
    } catch (const Error& error) {
        failures += (failures.empty() ? "" : "; ") + attempt + error.what();
    }
    return nullptr;
}

}  // namespace

std::unique_ptr<Platform> createZink(const PlatformOptions& options) {
    if (eglInUse())
        throw Error(
            "zink can only be chosen before EGL starts, and an EGL context already exists; destroy it first");
    std::string failures;
    if (!fileThatBegins("/dev/dri", "renderD").empty())
        if (auto platform = tryZink(options, false, failures)) return platform;
    if (auto platform = tryZink(options, true, failures)) return platform;
    throw Error("zink cannot create an OpenGL context (" + failures +
                "); install mesa-vulkan-drivers and libvulkan1, or use the back end egl");
}

}  // namespace vct::detail
