// vct info: what the driver is, and whether it has all that the pipeline needs.
#include <cstdio>
#include <string>

#include "cli/commands.h"
#include "gl/capabilities.h"
#include "platform/context.h"

namespace vct::cli {
namespace {

struct InfoOptions {
    std::string backend = "egl";
    int device = -1;
    bool listDevices = false;
};

constexpr const char* footer =
    "Exit code: 0 if everything that is required is there, 1 if something is missing or no context can be "
    "made.\n"
    "Examples:\n"
    "  vct info                     the default driver\n"
    "  vct info --list-devices      the indices that --device takes\n"
    "  vct info --backend zink      OpenGL over Vulkan (lavapipe where there is no GPU)";

void printDevices() {
    const std::vector<std::string> devices = eglDevices();
    if (devices.empty()) std::puts("EGL cannot enumerate devices here.");
    for (size_t i = 0; i < devices.size(); ++i)
        std::printf("%zu  %s\n", i, devices[i].c_str());
}

bool printCapabilities(const InfoOptions& options) {
    const Context context = openContext(backendFromName(options.backend), options.device);
    const gl::Capabilities& capabilities = context.capabilities;
    std::printf("back end:  %s, %s\n%s", options.backend.c_str(), context.platform->description().c_str(),
                gl::describe(capabilities).c_str());
    // A driver library without access to its GPU is a common surprise in containers.
    if (capabilities.softwareDriver && options.device < 0 && eglDevices().size() > 1)
        std::puts("EGL lists more than one device; --list-devices shows whether one of them is a GPU.");
    for (const gl::Requirement& row : capabilities.requirements) {
        if (row.required && !row.met) return false;
    }
    return true;
}

}  // namespace

void addInfo(CLI::App& app, int& exitCode) {
    CLI::App* command =
        app.add_subcommand("info", "Show the GL driver and whether it has what the pipeline needs");
    const auto options = std::make_shared<InfoOptions>();
    command
        ->add_option(
            "--backend", options->backend,
            "Where the context comes from: egl, osmesa (software, desktop context), zink (over Vulkan)")
        ->capture_default_str();
    command->add_option("--device", options->device, "Index of the EGL device (default: the driver's choice)")
        ->check(CLI::NonNegativeNumber);
    command->add_flag("--list-devices", options->listDevices,
                      "List the EGL devices with their indices, and stop");
    command->footer(footer);
    command->callback([options, &exitCode] {
        if (options->listDevices)
            printDevices();
        else if (!printCapabilities(*options))
            exitCode = 1;
    });
}

}  // namespace vct::cli
