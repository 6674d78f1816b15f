#include "cli/backend_option.h"

namespace vct::cli {

void BackendOption::addTo(CLI::App& command) {
    command
        .add_option("--backend", name,
                    "Where the context comes from: egl, osmesa (software, desktop context), zink (over "
                    "Vulkan)")
        ->capture_default_str();
    command
        .add_option("--device", device,
                    "EGL device by index (`vct info --list-devices`; default: the driver's choice)")
        ->check(CLI::Range(0, 1000));
}

}  // namespace vct::cli
