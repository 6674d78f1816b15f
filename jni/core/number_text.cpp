#include "core/number_text.h"

#include <cstdio>

namespace vct {

std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

}  // namespace vct
