// vct: the command-line tool. It runs the same shaders as the Android app.
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/guess.h"
#include "cli/options.h"
#include "core/files.h"
#include "core/one_line.h"
#include "vct/version.h"

namespace {

// Names the options that an error's advice refers to. The engine's messages speak of settings, because it
// knows nothing of the command line.
std::string optionsOf(const std::string& error) {
    std::string options;
    for (const auto& [advice, option] : {std::pair{"make room for", "--active-voxels"},
                                         {"lightFrames", "--light-frames"},
                                         {"ask for an animation", "--animation"},
                                         {"the back end egl", "--backend"},
                                         {"another back end", "--backend"},
                                         {"choose no device", "--device"},
                                         {"the camera's", "--camera"},
                                         {"cone angle", "--cone-angle"},
                                         {"shadow map must", "--shadow-map"},
                                         {"coarser grid", "--grid"},
                                         {"smaller picture", "--size"},
                                         {"allow files outside", "--allow-outside"}})
        if (error.find(advice) != std::string::npos)
            options += std::string(options.empty() ? "" : ", ") + option;
    return options.empty() ? "" : " (" + options + ")";
}

std::vector<std::string> commandsOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

// Explains what is wrong with a command line that names none of the commands.
std::string unknownCommand(const CLI::App& app, const std::vector<std::string>& arguments) {
    const std::vector<std::string> names = commandsOf(app);
    std::string list = "the commands are";
    for (const std::string& name : names)
        list += (name == names.front() ? " " : ", ") + name;
    if (arguments.empty()) return "A command is required; " + list;
    if (arguments.front()[0] == '-')
        return "'" + arguments.front() + "' stands where a command or a scene is needed; " + list;
    return "there is no command '" + vct::oneLine(arguments.front()) + "'" +
           vct::cli::guessText(vct::cli::guesses(arguments.front(), names)) + "; " + list;
}

// CLI11's text, or a clearer one.
std::string textOf(const CLI::App& command, const CLI::ParseError& error) {
    const std::string text = error.what();
    const std::size_t twice = text.find(": At Most 1 required");
    if (twice != std::string::npos) return text.substr(0, twice) + " is given more than once; give it once";
    constexpr const char* unreadable = "Could not convert: ";
    if (text.rfind(unreadable, 0) == 0)
        return text.substr(std::strlen(unreadable)) + " cannot be read; give a number in its range";
    const std::size_t missing = text.find(": 1 required ");
    if (missing != std::string::npos) return text.substr(0, missing) + " needs a value";
    const std::vector<std::string> unknown = command.remaining();
    const auto option = std::find_if(unknown.begin(), unknown.end(),
                                     [](const std::string& word) { return word.rfind('-', 0) == 0; });
    if (option == unknown.end())
        return unknown.empty()
                   ? text
                   : "'" + unknown.front() +
                         "' is one argument too many; give one scene, and quote a name with spaces";
    std::vector<std::string> names;
    for (const CLI::Option* known : command.get_options())
        if (!known->get_lnames().empty()) names.push_back("--" + known->get_lnames().front());
    return "there is no option " + *option + vct::cli::guessText(vct::cli::guesses(*option, names));
}

// The words of the command line. A scene's file without a command is rendered.
std::vector<std::string> argumentsOf(const CLI::App& app, int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const std::vector<std::string> names = commandsOf(app);
    if (words.empty() || std::find(names.begin(), names.end(), words.front()) != names.end()) return words;
    const bool beginsWithOption = words.front().rfind('-', 0) == 0;
    if (std::any_of(words.begin(), beginsWithOption ? words.end() : words.begin() + 1, vct::cli::isSceneFile))
        words.insert(words.begin(), "render");
    return words;
}

// Removes unfinished files and empty new folders, then lets the signal end the process as it would without a
// handler.
void endTidily(int signal) {
    vct::removeAfterInterruption();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

}  // namespace

int main(int argc, char** argv) {
    // Writing beyond `ulimit -f` becomes an error that is reported, as on a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, endTidily) == SIG_IGN) std::signal(signal, SIG_IGN);  // as under nohup
    CLI::App app("Global illumination by voxel cone tracing: pictures, step timings and comparisons.", "vct");
    app.footer(
        "`vct COMMAND --help` explains a command and its options. A first picture, "
        "out/cornell/gi-cone-shadow.png:\n"
        "  vct assets/cornell.glb      is short for vct render assets/cornell.glb\n"
        "The thesis that commands and options refer to, and that the preset `thesis` reproduces: C. Wahlén, "
        "Global Illumination in Real-Time using Voxel Cone Tracing on Mobile Devices, Linköping 2016.");
    app.set_version_flag("--version", "vct " VCT_VERSION);
    int exitCode = 0;
    vct::cli::addRender(app, exitCode);
    vct::cli::addView(app, exitCode);
    vct::cli::addBake(app, exitCode);
    vct::cli::addBench(app, exitCode);
    vct::cli::addCompare(app, exitCode);
    vct::cli::addInfo(app, exitCode);
    vct::cli::addShaders(app, exitCode);
    for (CLI::App* command : app.get_subcommands({}))
        for (CLI::Option* option : command->get_options()) {
            if (option->get_type_name().rfind("FLOAT", 0) == 0) option->check(vct::cli::finite);
            if (option->get_type_name().rfind("TEXT", 0) == 0) option->check(vct::cli::notEmpty);
        }
    const std::vector<std::string> arguments = argumentsOf(app, argc, argv);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(),
                                           arguments.rend()));  // CLI11 takes them from the back
        if (app.get_subcommands().empty()) throw CLI::RequiredError("A command");
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        const std::vector<CLI::App*> command = app.get_subcommands();
        if (command.empty())
            std::fprintf(stderr, "vct: error: %s; see vct --help\n", unknownCommand(app, arguments).c_str());
        else
            std::fprintf(stderr, "vct: error: %s; see vct %s --help\n",
                         textOf(*command.front(), error).c_str(), command.front()->get_name().c_str());
        return 1;
    } catch (const std::bad_alloc&) {
        std::fputs(
            "vct: error: not enough memory; ask for a smaller picture (--size) or a coarser grid (--grid), "
            "or free memory\n",
            stderr);
        return 1;
    } catch (const std::system_error& error) {
        std::fprintf(
            stderr,
            "vct: error: the system refused a resource (%s); end other programs, or raise the limits of "
            "processes and memory (ulimit -a)\n",
            error.what());
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "vct: error: %s%s\n", error.what(), optionsOf(error.what()).c_str());
        return 1;
    }
    // The last output may still be in the buffer.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        std::fprintf(stderr, "vct: error: cannot write to standard output: %s; redirect it elsewhere\n",
                     std::strerror(errno));
        return 1;
    }
    return exitCode;
}
