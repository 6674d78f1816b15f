// Android's log, under the tag `vct`: `adb logcat -s vct`.
#pragma once

#include <string>

namespace vct::app {

enum class LogLevel { info, warning, error };

// One entry per line of `text`; long lines are split, as the system cuts them off.
void log(LogLevel level, const std::string& text);
inline void log(const std::string& text) {
    log(LogLevel::info, text);
}

}  // namespace vct::app
