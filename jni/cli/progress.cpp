#include "cli/progress.h"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <system_error>

namespace vct::cli {

void say(const std::string& line) {
    std::fprintf(stderr, "%s\n", line.c_str());
}

Progress::Progress(const std::string& what, Begin begin) {
    if (begin == Begin::atOnce) say(what);
    const auto remind = [what](const std::stop_token& stop) {
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any stopped;
        const auto start = std::chrono::steady_clock::now();
        for (std::chrono::seconds at(2);; at *= 2) {
            stopped.wait_until(lock, stop, start + at, [] { return false; });
            if (stop.stop_requested()) return;
            say(what + ": " + std::to_string(at.count()) + " s so far");
        }
    };
    try {
        reminder_ = std::jthread(remind);
    } catch (const std::system_error&) {
        // The system starts no more threads. The work does not depend on the reminders.
    }
}

}  // namespace vct::cli
