// Progress messages on stderr; stdout is for results.
#pragma once

#include <string>
#include <thread>

namespace vct::cli {

void say(const std::string& line);

// Prints `what` at the beginning, and again after 2, 4, 8 and so on seconds until the object is destroyed.
class Progress {
  public:
    // `afterTwoSeconds` is for work that is usually quick: nothing is printed at the beginning.
    enum class Begin { atOnce, afterTwoSeconds };
    explicit Progress(const std::string& what, Begin begin = Begin::atOnce);

  private:
    std::jthread reminder_;  // its destructor stops and joins it
};

}  // namespace vct::cli
