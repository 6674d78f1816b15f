// The one type of exception that the library throws for what input, the driver or the machine can cause.
#pragma once

#include <stdexcept>

namespace vct {

// The message is one sentence that names what failed, why, and what to do about it.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace vct
