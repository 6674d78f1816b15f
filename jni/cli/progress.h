// Progress messages on stderr; stdout is for results.
#pragma once

#include <mutex>
#include <string>
#include <thread>

namespace vct::cli {

void say(const std::string& line);

// Prints `what` at the beginning, and again after 2, 4 and 8 seconds and then every 8 seconds until the
// object is destroyed.
class Progress {
  public:
    // `afterTwoSeconds` is for work that is usually quick: nothing is printed at the beginning.
    enum class Begin { atOnce, afterTwoSeconds };
    explicit Progress(const std::string& what, Begin begin = Begin::atOnce);

    // Names the part of the work that is done now in the next lines: "light: step 17 of 144".
    void setPart(const std::string& part);

  private:
    std::mutex mutex_;
    std::string part_;       // ": light: step 17 of 144", or ""
    std::jthread reminder_;  // its destructor stops and joins it
};

}  // namespace vct::cli
