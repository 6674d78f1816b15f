#include "desktop/file_dialog.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

#include "core/error.h"

extern char** environ;

namespace vct::desktop {

namespace {

// Runs a program with its standard output in a pipe. Returns 0 or the errno of the failure.
int start(const std::vector<const char*>& words, int output, pid_t& process) {
    std::vector<char*> arguments;
    for (const char* word : words)
        arguments.push_back(const_cast<char*>(word));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    // GTK prints warnings.
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const int cause = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return cause;
}

}  // namespace

FileDialog::FileDialog() {
    std::array<int, 2> pipe{};
    if (pipe2(pipe.data(), O_CLOEXEC) != 0)
        throw Error(std::string("cannot show a file dialog: ") + std::strerror(errno) +
                    "; drop the file on the window");
    int cause = start({"zenity", "--file-selection", "--title=Open a scene or a sky",
                       "--file-filter=Scenes and skies | *.glb *.gltf *.hdr"},
                      pipe[1], process_);
    if (cause != 0)
        cause = start({"kdialog", "--getopenfilename", ".", "*.glb *.gltf *.hdr|Scenes and skies"}, pipe[1],
                      process_);
    close(pipe[1]);
    output_ = pipe[0];
    if (cause == 0) return;
    close(output_);
    throw Error(
        "cannot show a file dialog, because neither zenity nor kdialog is installed; install one of them, or "
        "drop the file on the window");
}

FileDialog::~FileDialog() {
    if (process_ > 0) {
        kill(process_, SIGTERM);
        waitpid(process_, nullptr, 0);
    }
    close(output_);
}

std::optional<std::string> FileDialog::poll() {
    int status = 0;
    if (process_ <= 0 || waitpid(process_, &status, WNOHANG) != process_) return {};
    process_ = -1;
    std::string path;
    std::array<char, 4096> part{};
    for (ssize_t size = 0; (size = read(output_, part.data(), part.size())) > 0;)
        path.append(part.data(), static_cast<std::size_t>(size));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return "";
    while (!path.empty() && path.back() == '\n')
        path.pop_back();
    return path;
}

}  // namespace vct::desktop
