#include "app/android/thermal.h"

#include <dlfcn.h>

#include <cmath>

namespace vct::app {

namespace {

constexpr int forecastS = 10;

// The thermal manager of Android 11 and its headroom of Android 12. The app also runs on Android 7, so the
// functions are looked up when it runs.
class ThermalManager {
  public:
    ThermalManager() {
        void* const library = dlopen("libandroid.so", RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) return;
        const auto acquire = find<void* (*)()>(library, "AThermal_acquireManager");
        release_ = find<void (*)(void*)>(library, "AThermal_releaseManager");
        headroom_ = find<float (*)(void*, int)>(library, "AThermal_getThermalHeadroom");
        if (acquire != nullptr && release_ != nullptr && headroom_ != nullptr) manager_ = acquire();
    }
    ~ThermalManager() {
        if (manager_ != nullptr) release_(manager_);
    }
    ThermalManager(const ThermalManager&) = delete;
    ThermalManager& operator=(const ThermalManager&) = delete;

    std::optional<float> headroom() const {
        if (manager_ == nullptr) return {};
        const float headroom = headroom_(manager_, forecastS);
        if (std::isnan(headroom)) return {};
        return headroom;
    }

  private:
    template <typename Function>
    static Function find(void* library, const char* name) {
        return reinterpret_cast<Function>(dlsym(library, name));
    }

    void (*release_)(void*) = nullptr;
    float (*headroom_)(void*, int) = nullptr;
    void* manager_ = nullptr;
};

}  // namespace

std::optional<float> thermalHeadroom() {
    static const ThermalManager manager;
    return manager.headroom();
}

}  // namespace vct::app
