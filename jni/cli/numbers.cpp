#include "cli/numbers.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace vct::cli {

std::string finite(const std::string& text) {
    float value = 0.0F;
    return CLI::detail::lexical_cast(text, value) && std::isfinite(value) ? ""
                                                                          : "'" + text + "' is not a number";
}

std::string positive(const std::string& text) {
    return finite(text).empty() && std::stod(text) > 0.0 ? "" : "'" + text + "' is not a number above 0";
}

}  // namespace vct::cli
