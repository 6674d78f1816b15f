// What is being done, on stderr: stdout is for results.
#pragma once

#include <string>
#include <thread>

namespace vct::cli {

void say(const std::string& line);

// Says what is being done, and while it lasts, after 2, 4, 8 and so on seconds, that it still is.
class Progress {
  public:
    explicit Progress(const std::string& what);

  private:
    std::jthread reminder_;  // its destructor stops and joins it
};

}  // namespace vct::cli
