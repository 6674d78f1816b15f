#include "cli/progress.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <system_error>

namespace vct::cli {

void say(const std::string& line) {
    std::fprintf(stderr, "%s\n", line.c_str());
}

Progress::Progress(const std::string& what, Begin begin) {
    if (begin == Begin::atOnce) say(what);
    const auto remind = [this, what](const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        std::condition_variable_any stopped;
        const auto start = std::chrono::steady_clock::now();
        for (std::chrono::seconds at(2);; at += std::min(at, std::chrono::seconds(8))) {
            stopped.wait_until(lock, stop, start + at, [] { return false; });
            if (stop.stop_requested()) return;
            say(what + part_ + ": " + std::to_string(at.count()) + " s so far");
        }
    };
    try {
        reminder_ = std::jthread(remind);
    } catch (const std::system_error&) {
        // The system starts no more threads. The work does not depend on the reminders.
    }
}

void Progress::setPart(const std::string& part) {
    const std::scoped_lock lock(mutex_);
    part_ = ": " + part;
}

}  // namespace vct::cli
