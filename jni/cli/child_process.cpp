#include "cli/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <fstream>

#include "core/error.h"

extern char** environ;

namespace vct::cli {

namespace {

volatile sig_atomic_t runningChild = 0;
volatile sig_atomic_t interruption = 0;

void passOn(int signal) {
    interruption = signal;
    if (runningChild > 0) kill(static_cast<pid_t>(runningChild), signal);
}

// While a child runs, an interruption ends the child and then becomes an error here, so that this process
// still tidies up after itself.
class InterruptionAsError {
  public:
    InterruptionAsError() {
        interruption = 0;
        struct sigaction action {};
        action.sa_handler = passOn;
        for (std::size_t i = 0; i < signals.size(); ++i)
            sigaction(signals[i], &action, &before_[i]);
    }
    ~InterruptionAsError() {
        runningChild = 0;
        for (std::size_t i = 0; i < signals.size(); ++i)
            sigaction(signals[i], &before_[i], nullptr);
    }
    InterruptionAsError(const InterruptionAsError&) = delete;
    InterruptionAsError& operator=(const InterruptionAsError&) = delete;

  private:
    static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, 3> before_{};
};

// The line that main() prints for an error; without one (a crash), whatever was said last.
std::string lastWords(const std::string& logFile) {
    static const std::string mark = "vct: error: ";
    std::ifstream log(logFile);
    std::string last = "it said nothing";
    for (std::string line; std::getline(log, line);) {
        if (line.rfind(mark, 0) == 0) return line.substr(mark.size());
        if (!line.empty()) last = line;
    }
    return last;
}

pid_t spawn(const std::vector<std::string>& arguments, const std::string& logFile) {
    std::vector<char*> pointers{const_cast<char*>("vct")};
    for (const std::string& argument : arguments)
        pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, 2, logFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    pid_t child = 0;
    // This very program, even where its file was replaced or renamed since it started.
    const int cause = posix_spawn(&child, "/proc/self/exe", &files, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (cause != 0) throw Error(std::string("cannot start a process: ") + strerror(cause));
    return child;
}

}  // namespace

void runSelf(const std::vector<std::string>& arguments, const std::string& logFile) {
    const InterruptionAsError guard;
    const pid_t child = spawn(arguments, logFile);
    runningChild = child;
    if (interruption != 0) kill(child, interruption);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw Error(std::string("cannot wait for a process: ") + strerror(errno));
    runningChild = 0;
    if (interruption != 0) throw Error("interrupted");
    if (WIFSIGNALED(status))
        throw Error(std::string("ended by a signal (") + strsignal(WTERMSIG(status)) +
                    "); its last words: " + lastWords(logFile));
    if (WEXITSTATUS(status) != 0) throw Error(lastWords(logFile));
}

}  // namespace vct::cli
