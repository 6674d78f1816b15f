// Numbers as people write them.
#pragma once

#include <cstddef>
#include <string>

namespace vct {

// Up to six digits, and no zeros at the end: "2", "0.25", "1e-07".
std::string numberText(double value);

// Rounded up: "1 MB" for one byte.
std::string megabytesText(std::size_t bytes);

}  // namespace vct
