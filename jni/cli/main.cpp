// vct: voxel cone tracing on the desktop, by the shaders that the phone runs.
#include <csignal>
#include <cstdio>
#include <exception>

#include "cli/commands.h"

int main(int argc, char** argv) {
    CLI::App app("Global illumination by voxel cone tracing: pictures, step timings and comparisons.", "vct");
    app.set_version_flag("--version", "vct " VCT_VERSION);
    // Writing beyond `ulimit -f` shall be an error that is reported and tidied up after, as on a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    app.require_subcommand(1);
    int exitCode = 0;
    vct::cli::addRender(app, exitCode);
    vct::cli::addBench(app, exitCode);
    vct::cli::addCompare(app, exitCode);
    vct::cli::addInfo(app, exitCode);
    vct::cli::addShaders(app, exitCode);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "vct: error: %s\n", error.what());
        return 1;
    }
    return exitCode;
}
