#include "app/log.h"

#include <android/log.h>

#include <sstream>

namespace vct::app {

// One entry per line of `text`; long lines are split, as the system cuts them off.
void log(LogLevel level, const std::string& text) {
    const int priority = level == LogLevel::error     ? ANDROID_LOG_ERROR
                         : level == LogLevel::warning ? ANDROID_LOG_WARN
                                                      : ANDROID_LOG_INFO;
    constexpr std::size_t longest =
        1000;  // an entry holds about 4000 bytes with its tag; `logcat` shows fewer
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        for (std::size_t at = 0; at == 0 || at < line.size(); at += longest)
            __android_log_write(priority, "vct", line.substr(at, longest).c_str());
}

}  // namespace vct::app
