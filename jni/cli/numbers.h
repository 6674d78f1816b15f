// Checks of options whose value is a number. They return what is wrong, or nothing.
#pragma once

#include <string>

namespace vct::cli {

// CLI11 takes NaN and infinity for numbers, and knows no float's limits.
std::string finite(const std::string& text);
// Finite and above 0.
std::string positive(const std::string& text);

}  // namespace vct::cli
