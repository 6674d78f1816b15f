// The exception that the library throws for errors of input, driver or machine.
#pragma once

#include <stdexcept>

namespace vct {

// The message says what failed, why, and what to do about it.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace vct
