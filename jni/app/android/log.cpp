#include "app/log.h"

#include <android/log.h>

#include <sstream>

namespace vct::app {

// Writes one log entry per line of `text`. Long lines are split, because the system would cut them off.
void log(LogLevel level, const std::string& text) {
    const int priority = level == LogLevel::error     ? ANDROID_LOG_ERROR
                         : level == LogLevel::warning ? ANDROID_LOG_WARN
                                                      : ANDROID_LOG_INFO;
    // An entry holds about 4000 bytes with its tag, and `logcat` shows fewer.
    constexpr std::size_t longest = 1000;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        for (std::size_t at = 0; at == 0 || at < line.size(); at += longest)
            __android_log_write(priority, "vct", line.substr(at, longest).c_str());
}

}  // namespace vct::app
