// What is wrong with a command line that CLI11 refuses, in words of this program.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace vct::cli {

// `app`: the program, after it has thrown `error`. Says where to read on.
std::string parseErrorText(const CLI::App& app, const CLI::ParseError& error);

}  // namespace vct::cli
