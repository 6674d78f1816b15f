// vct: voxel cone tracing on the desktop, by the shaders that the phone runs.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/files.h"

namespace {

// By what options to follow the advice of an error: the engine knows no command line.
std::string optionsOf(const std::string& error) {
    std::string options;
    for (const auto& [advice, option] : {std::pair{"make room for", "--active-voxels"},
                                         {"coarser grid", "--grid"},
                                         {"smaller picture", "--size"},
                                         {"allow files outside", "--allow-outside"}})
        if (error.find(advice) != std::string::npos)
            options += std::string(options.empty() ? "" : ", ") + option;
    return options.empty() ? "" : " (" + options + ")";
}

// As if there were no handler, but for what is half made: nobody shall find an empty folder.
void endTidily(int signal) {
    vct::removeAfterInterruption();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

}  // namespace

int main(int argc, char** argv) {
    // Writing beyond `ulimit -f` shall be an error that is reported and tidied up after, as on a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, endTidily) == SIG_IGN) std::signal(signal, SIG_IGN);  // nohup
    CLI::App app("Global illumination by voxel cone tracing: pictures, step timings and comparisons.", "vct");
    app.set_version_flag("--version", "vct " VCT_VERSION);
    int exitCode = 0;
    vct::cli::addRender(app, exitCode);
    vct::cli::addView(app, exitCode);
    vct::cli::addBench(app, exitCode);
    vct::cli::addCompare(app, exitCode);
    vct::cli::addInfo(app, exitCode);
    vct::cli::addShaders(app, exitCode);
    for (CLI::App* command : app.get_subcommands({}))
        for (CLI::Option* option : command->get_options())
            if (option->get_type_name().rfind("FLOAT", 0) == 0) option->check(vct::cli::finite);
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty()) throw CLI::RequiredError("A command");
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        const std::vector<CLI::App*> command = app.get_subcommands();
        const std::string help =
            command.empty() ? "vct --help" : "vct " + command.front()->get_name() + " --help";
        std::fprintf(stderr, "vct: error: %s; see %s\n", error.what(), help.c_str());
        return 1;
    } catch (const std::bad_alloc&) {
        std::fputs(
            "vct: error: there is not enough memory; ask for a smaller picture (--size) or a coarser "
            "grid (--grid), or free memory\n",
            stderr);
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "vct: error: %s%s\n", error.what(), optionsOf(error.what()).c_str());
        return 1;
    }
    // What was printed may still be in the buffer.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        std::fprintf(stderr, "vct: error: cannot write to standard output: %s; send it elsewhere\n",
                     std::strerror(errno));
        return 1;
    }
    return exitCode;
}
