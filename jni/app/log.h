// What the app and `vct view` say: on Android to its log, under the tag `vct` (`adb logcat -s vct`), on a
// desktop to stderr, but for details.
#pragma once

#include <string>

namespace vct::app {

enum class LogLevel { detail, info, warning, error };

void log(LogLevel level, const std::string& text);
inline void log(const std::string& text) {
    log(LogLevel::info, text);
}

}  // namespace vct::app
