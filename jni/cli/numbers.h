// What options take whose value is a number.
#pragma once

#include <CLI/CLI.hpp>

namespace vct::cli {

// A finite number for which `allowed` holds. `what` ends the sentence "'x' is not ...".
CLI::Validator number(const char* what, bool (*allowed)(double value));

// Gives every option of `command` that takes a number a check of its own: CLI11 takes NaN and infinity for
// numbers, and of the rest it says only that it could not convert them.
void checkNumbers(CLI::App& command);

}  // namespace vct::cli
