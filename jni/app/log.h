// Messages of the app and of `vct view`. On Android they go to the system log under the tag `vct` (`adb
// logcat -s vct`), on a desktop to stderr, without those of level `detail`.
#pragma once

#include <string>

namespace vct::app {

enum class LogLevel { detail, info, warning, error };

void log(LogLevel level, const std::string& text);
inline void log(const std::string& text) {
    log(LogLevel::info, text);
}

}  // namespace vct::app
