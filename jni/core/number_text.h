// Text of numbers for messages.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace vct {

// Up to six significant digits without trailing zeros: "2", "0.25", "1e-07".
inline std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

// Megabytes, rounded up: "1 MB" for one byte.
inline std::string megabytesText(std::size_t bytes) {
    return std::to_string((bytes + 999999) / 1000000) + " MB";
}

}  // namespace vct
