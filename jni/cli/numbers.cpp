#include "cli/numbers.h"

#include <cmath>
#include <limits>

namespace vct::cli {

namespace {

std::string isNot(const std::string& text, const char* what) {
    return "'" + text + "' is not " + what;
}

template <class Integer>
CLI::Validator integer(const char* what) {
    const auto check = [=](std::string& text) {
        Integer value = 0;
        return CLI::detail::lexical_cast(text, value) ? std::string() : isNot(text, what);
    };
    return CLI::Validator(check, "");
}

}  // namespace

CLI::Validator number(const char* what, bool (*allowed)(double)) {
    const auto check = [=](std::string& text) {
        double value = 0.0;
        const bool isNumber = CLI::detail::lexical_cast(text, value) &&
                              std::abs(value) <= double(std::numeric_limits<float>::max());
        return isNumber && allowed(value) ? std::string() : isNot(text, what);
    };
    return CLI::Validator(check, "");
}

void checkNumbers(CLI::App& command) {
    for (CLI::Option* option : command.get_options()) {
        const std::string type = option->get_type_name();
        if (type == "FLOAT") option->check(number("a number", [](double) { return true; }));
        if (type == "INT") option->check(integer<int>("a whole number, or too large"));
        if (type == "UINT") option->check(integer<unsigned>("a whole number of 0 or more, or too large"));
    }
}

}  // namespace vct::cli
