// --backend and --device, of the commands that take them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace vct::cli {

struct BackendOption {
    std::string name = "egl";
    int device = -1;  // the driver's choice

    void addTo(CLI::App& command);
};

}  // namespace vct::cli
