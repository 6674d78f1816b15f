// What is being done, on stderr: stdout is for results.
#pragma once

#include <string>
#include <thread>

namespace vct::cli {

void say(const std::string& line);

// Says what is being done, and while it lasts, after 2, 4, 8 and so on seconds, that it still is.
class Progress {
  public:
    // Work that is usually done at once need not be announced.
    enum class Begin { atOnce, afterTwoSeconds };
    explicit Progress(const std::string& what, Begin begin = Begin::atOnce);

  private:
    std::jthread reminder_;  // its destructor stops and joins it
};

}  // namespace vct::cli
