// Zink is Mesa's OpenGL over Vulkan. EGL has no name for it: which driver Mesa loads is decided by
// environment variables that it reads when the display is initialised.
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

// Sets variables for as long as it lives, so that an EGL context created later in this process is not zink
// too. Like setenv itself, not for use while other threads read the environment.
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

// A file of the folder whose name begins so; empty where there is none.
std::string fileThatBegins(const char* folder, const std::string& start) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().filename().string().rfind(start, 0) == 0) return entry.path().string();
    return "";
}

// The Vulkan loader's description of lavapipe, Mesa's Vulkan on the CPU; empty where it is not installed.
std::string lavapipeIcd() {
    for (const char* folder :
         {"/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/etc/vulkan/icd.d"})
        if (const std::string icd = fileThatBegins(folder, "lvp_icd."); !icd.empty()) return icd;
    return "";
}

// GL_RENDERER of the current context, whose entry points are not loaded yet.
std::string rendererOf(const Platform& platform) {
    constexpr unsigned glRenderer = 0x1F01;
    using GetString = const unsigned char* (*)(unsigned);
    const auto getString = reinterpret_cast<GetString>(platform.getProcAddress("glGetString"));
    const unsigned char* text = getString ? getString(glRenderer) : nullptr;
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

// Returns null, and adds why to `failures`, where what comes is not zink.
std::unique_ptr<Platform> tryZink(const PlatformOptions& options, bool software, std::string& failures) {
    ScopedEnvironment environment;
    environment.set("GALLIUM_DRIVER", "zink");
    environment.set("MESA_LOADER_DRIVER_OVERRIDE", "zink");
    // lavapipe asks libwayland for a compositor, which complains on stderr when this is unset. A folder that
    // does not exist gives the same answer (there is none) in silence.
    environment.setIfUnset("XDG_RUNTIME_DIR", "/nonexistent");
    if (software) {
        environment.set("LIBGL_ALWAYS_SOFTWARE", "1");
        // Without this the loader also opens the drivers of GPUs that are not there, and may put one first.
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
