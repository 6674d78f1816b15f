// A stand-in for Android's liblog.so, which keeps the log in memory too.
#include <android/log.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <mutex>

#include "stand_in.h"

namespace stand_in {

namespace {

std::mutex logMutex;
std::vector<std::string> logLines;

}  // namespace

bool isLogged(const std::string& text, std::size_t first) {
    const std::lock_guard lock(logMutex);
    for (std::size_t i = first; i < logLines.size(); ++i)
        if (logLines[i].find(text) != std::string::npos) return true;
    return false;
}

std::size_t logSize() {
    const std::lock_guard lock(logMutex);
    return logLines.size();
}

}  // namespace stand_in

extern "C" int __android_log_write(int priority, const char* tag, const char* text) {
    const std::lock_guard lock(stand_in::logMutex);
    stand_in::logLines.emplace_back(text);
    return std::fprintf(stderr, "%c/%s(%d): %s\n", "??VDIWEF"[priority & 7], tag,
                        static_cast<int>(syscall(SYS_gettid)), text);
}

extern "C" int __android_log_print(int priority, const char* tag, const char* format, ...) {
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return __android_log_write(priority, tag, text);
}
