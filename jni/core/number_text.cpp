#include "core/number_text.h"

#include <cstdio>

namespace vct {

std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string megabytesText(std::size_t bytes) {
    return std::to_string((bytes + 999999) / 1000000) + " MB";
}

}  // namespace vct
