// vct: voxel cone tracing on the desktop, by the shaders that the phone runs.
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include "cli/commands.h"
#include "cli/options.h"

namespace {

// By what options to follow the advice of an error: the engine knows no command line.
std::string optionsOf(const std::string& error) {
    std::string options;
    for (const auto& [advice, option] : {std::pair{"make room for", "--active-voxels"},
                                         {"coarser grid", "--grid"},
                                         {"smaller picture", "--size"}})
        if (error.find(advice) != std::string::npos)
            options += std::string(options.empty() ? "" : ", ") + option;
    return options.empty() ? "" : " (" + options + ")";
}

}  // namespace

int main(int argc, char** argv) {
    // Writing beyond `ulimit -f` shall be an error that is reported and tidied up after, as on a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
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
    } catch (const std::exception& error) {
        std::fprintf(stderr, "vct: error: %s%s\n", error.what(), optionsOf(error.what()).c_str());
        return 1;
    }
    return exitCode;
}
