#include "lab/shader_conditions.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "core/error.h"

namespace vct {

namespace {

using Macros = std::map<std::string, std::string>;

// The value of an integer or of a macro that is one.
long valueOf(const std::string& word, const Macros& macros) {
    if (std::isdigit(static_cast<unsigned char>(word[0])) != 0) return std::stol(word, nullptr, 0);
    const auto macro = macros.find(word);
    if (macro == macros.end() || macro->second == word)
        throw Error("a condition of a shader compares " + word + ", which is not a number");
    return valueOf(macro->second, macros);
}

// Evaluates comparisons and defined(), joined by && and ||.
bool isTrue(const std::string& condition, const Macros& macros) {
    static const std::regex term(
        R"(\s*(?:(!?)\s*defined\s*\(\s*(\w+)\s*\)|(\w+)\s*([<>=!]=|[<>])\s*(\w+))\s*)");
    bool any = false, all = true;
    for (std::size_t begin = 0; begin <= condition.size();) {
        const std::size_t end = std::min(condition.find_first_of("&|", begin), condition.size());
        std::smatch match;
        const std::string text = condition.substr(begin, end - begin);
        if (!std::regex_match(text, match, term))
            throw Error("the condition '" + condition +
                        "' of a shader cannot be read; use comparisons of integers and macros, defined(), && "
                        "and ||, without other brackets (jni/lab/shader_conditions.cpp)");
        if (match[2].matched) {
            all &= (macros.count(match[2]) > 0) == (match[1].length() == 0);
        } else if (all) {
            const long a = valueOf(match[3], macros), b = valueOf(match[5], macros);
            const std::string compare = match[4];
            all = (a == b && compare != "!=" && compare.find('=') != std::string::npos) ||
                  (a < b && (compare[0] == '<' || compare[0] == '!')) ||
                  (a > b && (compare[0] == '>' || compare[0] == '!'));
        }
        if (end == condition.size() || condition[end] == '|') {
            any |= all;
            all = true;
        }
        begin = end + 2;
    }
    return any;
}

void blank(std::string& text, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
        if (text[i] != '\n') text[i] = ' ';
}

void blankComments(std::string& text) {
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != '/' || (text[i + 1] != '/' && text[i + 1] != '*')) continue;
        const bool isLine = text[i + 1] == '/';
        std::size_t end = text.find(isLine ? "\n" : "*/", i);
        end = end == std::string::npos ? text.size() : end + (isLine ? 0 : 2);
        blank(text, i, end);
    }
}

// A level of nested conditions.
struct Level {
    bool active;  // this branch is compiled
    bool taken;   // this branch or one before it is
};

}  // namespace

std::string activeSource(const std::string& source) {
    std::string text = source;
    blankComments(text);
    Macros macros;
    std::vector<Level> levels{{true, true}};
    static const std::regex directive(R"(\s*#\s*(\w+)\s*((\w*)\s*(.*?))\s*)");
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = std::min(text.find('\n', begin), text.size());
        const bool isDirective = text.find_first_not_of(" \t", begin) == text.find('#', begin);
        // A backslash continues a directive.
        while (isDirective && end > begin && text[end - 1] == '\\') {
            text[end - 1] = ' ';
            end = std::min(text.find('\n', end + 1), text.size());
        }
        std::smatch match;
        std::string line = text.substr(begin, end - begin);
        std::replace(line.begin(), line.end(), '\n', ' ');
        if (isDirective && std::regex_match(line, match, directive)) {
            const std::string kind = match[1], condition = match[2], name = match[3], rest = match[4];
            const bool outer = levels.size() < 2 || levels[levels.size() - 2].active;
            const auto enter = [&](bool holds) { levels.push_back({levels.back().active && holds, holds}); };
            const auto next = [&](bool holds) {
                Level& level = levels.back();
                level.active = outer && !level.taken && holds;
                level.taken = level.taken || holds;
            };
            if (kind == "ifdef" || kind == "ifndef")
                enter((macros.count(name) != 0) == (kind == "ifdef"));
            else if (kind == "if")
                enter(levels.back().active && isTrue(condition, macros));
            else if (kind == "elif")
                next(outer && !levels.back().taken && isTrue(condition, macros));
            else if (kind == "else")
                next(true);
            else if (kind == "endif" && levels.size() > 1)
                levels.pop_back();
            else if (kind == "version")
                macros["__VERSION__"] = name;
            else if (kind == "define" && levels.back().active)
                macros[name] = rest;
            else if (kind == "undef" && levels.back().active)
                macros.erase(name);
        }
        if (isDirective || !levels.back().active) blank(text, begin, end);
        begin = end + 1;
    }
    return text;
}

}  // namespace vct
