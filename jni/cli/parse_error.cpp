#include "cli/parse_error.h"

#include <algorithm>

namespace vct::cli {

namespace {

std::string commandList(const CLI::App& app) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands({}))
        names += (names.empty() ? "" : ", ") + command->get_name();
    return names;
}

// CLI11 lists what is left over from its end, and cannot tell an unknown option from its value.
std::string leftOverText(const std::vector<std::string>& arguments) {
    const auto option = std::find_if(arguments.begin(), arguments.end(),
                                     [](const std::string& text) { return text.rfind('-', 0) == 0; });
    if (option != arguments.end()) return "there is no option " + *option;
    return "'" + arguments.front() + "' is one argument too many";
}

// CLI11: "--out: 1 required TEXT missing", "--out: At Most 1 required but received 2".
std::string countText(const std::string& text) {
    const std::string option = text.substr(0, text.find(':'));
    if (text.find("missing") != std::string::npos) return option + " needs a value";
    if (text.find("received") != std::string::npos) return option + " is given more than once";
    return text;
}

}  // namespace

std::string parseErrorText(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<std::string> leftOver = app.remaining(true);
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    if (chosen.empty())
        return (leftOver.empty() ? "no command is given" : "'" + leftOver.front() + "' is not a command") +
               "; the commands are " + commandList(app) + " (vct --help)";
    std::string cause = error.what();
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) cause = leftOverText(leftOver);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) cause = countText(cause);
    return cause + "; see vct " + chosen.front()->get_name() + " --help";
}

}  // namespace vct::cli
