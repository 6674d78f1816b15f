#include "api/look_up.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

namespace vct {

namespace {

bool startsWith(const std::string& line, const char* text) {
    return line.rfind(text, 0) == 0;
}

// The lines of an assembled shader without comments, empty lines, C++ and what must stand at a shader's
// beginning or only makes sense in its own file.
std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    bool isCpp = false, isInCppBranch = false;
    for (std::string line; std::getline(stream, line);) {
        line.erase(std::min(line.find("//"), line.size()));
        line.erase(line.find_last_not_of(" \t") + 1);
        if (line == "#ifdef __cplusplus") isCpp = isInCppBranch = true;
        const bool ends = isInCppBranch && line == "#endif", turns = isInCppBranch && line == "#else";
        if (ends || turns) isCpp = false;
        if (ends) isInCppBranch = false;
        bool isKept = !line.empty() && !isCpp && !ends && !turns;
        for (const char* start : {"#version", "#extension", "#line", "precision "})
            isKept &= !startsWith(line, start);
        if (isKept) lines.push_back(line);
    }
    return lines;
}

// Finds the names that code declares outside of functions and structs: types, functions, constants and
// uniforms, also those in uniform blocks.
class DeclaredNames {
  public:
    void read(const std::string& line) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const char c = line[i];
            if (std::isalpha(static_cast<unsigned char>(c)) || c == '_') {
                std::size_t end = i;
                while (end < line.size() &&
                       (std::isalnum(static_cast<unsigned char>(line[end])) || line[end] == '_'))
                    ++end;
                word(line.substr(i, end - i));
                i = end - 1;
            } else if (c != ' ') {
                symbol(c);
            }
        }
    }
    const std::set<std::string>& names() const { return names_; }

  private:
    void word(const std::string& word) {
        if (parentheses_ > 0) return;
        if (braces_ == 0 && word == "uniform") isUniform_ = true;
        last_ = word;
    }
    void symbol(char c) {
        const bool declares =
            parentheses_ == 0 && !isInitializer_ && (braces_ == 0 || (braces_ == 1 && isUniform_));
        if (declares && (c == '(' || c == '=' || c == ';' || c == '{' || c == '[') && last_ != "layout" &&
            !last_.empty())
            names_.insert(last_);
        last_.clear();
        if (c == '=' && braces_ + parentheses_ == 0) isInitializer_ = true;
        if (c == ',' && braces_ + parentheses_ == 0) isInitializer_ = false;
        if (c == '(') ++parentheses_;
        if (c == ')') --parentheses_;
        if (c == '{') ++braces_;
        if (c == '}') --braces_;
        if (braces_ == 0 && (c == ';' || c == '}')) isUniform_ = isInitializer_ = false;
    }

    std::set<std::string> names_;
    std::string last_;
    int braces_ = 0, parentheses_ = 0;
    bool isUniform_ = false, isInitializer_ = false;
};

}  // namespace

std::string embeddableGlsl(const gl::ReadShader& read, const std::string& path,
                           const std::vector<std::string>& defines, const std::string& function) {
    const std::vector<std::string> lines =
        linesOf(gl::assembleShader(read, path, defines, gl::Language::essl310).text);
    DeclaredNames declared;
    std::set<std::string> macros;
    for (const std::string& line : lines) {
        std::string directive, name;
        std::istringstream words(line);
        if (line[0] != '#')
            declared.read(line);
        else if (words >> directive >> name && directive == "#define")
            macros.insert(name.substr(0, name.find('(')));
    }
    std::string text;
    for (const std::string& name : declared.names()) {
        if (name == function || macros.contains(name)) continue;
        text += "#define " + name + " vct_" + name + "\n";
        macros.insert(name);
    }
    for (const std::string& line : lines)
        text += line + "\n";
    for (const std::string& macro : macros)
        text += "#undef " + macro + "\n";
    return text;
}

}  // namespace vct
