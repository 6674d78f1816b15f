// The commands of `vct`, one file each. A command declares its options on `app` and runs from its callback.
// It throws vct::Error if it fails, and sets `exitCode` for an expected negative result (two pictures
// differ).
#pragma once

#include <CLI/CLI.hpp>

namespace vct::cli {

void addBake(CLI::App& app, int& exitCode);
void addRender(CLI::App& app, int& exitCode);
void addBench(CLI::App& app, int& exitCode);
void addCompare(CLI::App& app, int& exitCode);
void addInfo(CLI::App& app, int& exitCode);
void addShaders(CLI::App& app, int& exitCode);
void addView(CLI::App& app, int& exitCode);

}  // namespace vct::cli
