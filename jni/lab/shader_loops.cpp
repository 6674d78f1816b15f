#include "lab/shader_loops.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "core/error.h"
#include "lab/shader_conditions.h"
#include "shared/layout.h"

namespace vct {

namespace {

struct Token {
    std::string text;
    std::size_t begin, end;  // in the source
};

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::vector<Token> tokensOf(const std::string& text) {
    std::vector<Token> tokens;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t begin = i;
        if (isWordCharacter(text[i])) {
            while (i < text.size() && (isWordCharacter(text[i]) || text[i] == '.'))
                ++i;
            // `rays.count`, but not `1.0`, is three tokens.
            const std::size_t dot = text.find('.', begin);
            if (dot < i && std::isdigit(static_cast<unsigned char>(text[begin])) == 0) i = dot;
        } else {
            ++i;
            if (std::isspace(static_cast<unsigned char>(text[begin])) != 0) continue;
        }
        tokens.push_back({text.substr(begin, i - begin), begin, i});
    }
    return tokens;
}

// A loop, or a call of a function that the shader defines.
struct Node {
    std::string function;  // the callee; empty: a loop
    std::size_t arguments = 0;
    std::size_t begin = 0;  // of a loop, in the source
    bool constant = false;
    std::size_t counter = 0;
    std::vector<Node> inner;
};

struct Function {
    std::size_t parameters;
    std::vector<Node> body;
};

class Reader {
  public:
    Reader(gl::AssembledShader& source, std::size_t firstCounter)
        : source_(source),
          active_(activeSource(source.text)),
          tokens_(tokensOf(active_)),
          counter_(firstCounter) {}

    CountedShader read() {
        CountedShader shader{counter_, 0, {}};
        findFunctions();
        const std::size_t first = counter_++;
        for (const Definition& definition : definitions_) {
            if (definition.name == "main") insert(tokens_[definition.body].end, count(first));
            at_ = definition.body;
            std::vector<Node> body;
            readStatement(body);
            functions_.emplace(definition.name, Function{definition.parameters, std::move(body)});
        }
        const auto main = functions_.find("main");
        if (main == functions_.end()) fail(0, "there is no main()");
        list(main->second.body, 0, shader.loops);
        shader.counterCount = counter_ - first;
        apply();
        return shader;
    }

  private:
    struct Definition {
        std::string name;
        std::size_t parameters;
        std::size_t body;  // the token `{`
    };

    [[noreturn]] void fail(std::size_t token, const std::string& why) const {
        throw Error("shaders/" + placeOf(token < tokens_.size() ? tokens_[token].begin : 0) + ": " + why +
                    "; jni/lab/shader_loops.cpp reads loops and calls as the other shaders write them");
    }
    bool is(std::size_t token, const char* text) const {
        return token < tokens_.size() && tokens_[token].text == text;
    }
    // The token that closes the bracket `open`.
    std::size_t closing(std::size_t open) const {
        int depth = 0;
        for (std::size_t i = open; i < tokens_.size(); ++i) {
            if (is(i, "(") || is(i, "[") || is(i, "{")) ++depth;
            if (is(i, ")") || is(i, "]") || is(i, "}")) --depth;
            if (depth == 0) return i;
        }
        fail(open, "this bracket is not closed");
    }
    // The number of expressions or parameters in the brackets.
    std::size_t countOf(std::size_t open, std::size_t close) const {
        if (close == open + 1 || (close == open + 2 && is(open + 1, "void"))) return 0;
        std::size_t number = 1;
        for (std::size_t i = open + 1; i < close; ++i) {
            if (is(i, "(") || is(i, "[") || is(i, "{")) i = closing(i);
            if (is(i, ",")) ++number;
        }
        return number;
    }

    // Finds the definitions of functions and the names of constants.
    void findFunctions() {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (is(i, "const") && i + 2 < tokens_.size()) constants_.insert(tokens_[i + 2].text);
            if (is(i, "(")) {
                const std::size_t close = closing(i);
                if (is(close + 1, "{")) {
                    definitions_.push_back({tokens_[i - 1].text, countOf(i, close), close + 1});
                    names_.insert(tokens_[i - 1].text);
                }
                i = close;
            }
            if (is(i, "{")) i = closing(i);
        }
    }

    // Reads the calls in an expression. Those of its arguments come before a call.
    void readCalls(std::size_t begin, std::size_t end, std::vector<Node>& nodes) const {
        for (std::size_t i = begin; i < end; ++i) {
            if (!is(i + 1, "(") || names_.count(tokens_[i].text) == 0) continue;
            const std::size_t close = closing(i + 1);
            readCalls(i + 2, close, nodes);
            Node call;
            call.function = tokens_[i].text;
            call.arguments = countOf(i + 1, close);
            nodes.push_back(std::move(call));
            i = close;
        }
    }

    // Reads the statement at at_.
    void readStatement(std::vector<Node>& nodes) {
        if (is(at_, "{")) {
            const std::size_t close = closing(at_++);
            while (at_ < close)
                readStatement(nodes);
            at_ = close + 1;
        } else if (is(at_, "if")) {
            const std::size_t close = closing(at_ + 1);
            readCalls(at_ + 2, close, nodes);
            at_ = close + 1;
            readStatement(nodes);
            if (is(at_, "else")) {
                ++at_;
                readStatement(nodes);
            }
        } else if (is(at_, "for") || is(at_, "while") || is(at_, "do")) {
            readLoop(nodes);
        } else {
            const std::size_t begin = at_;
            while (!is(at_, ";")) {
                if (is(at_, "(") || is(at_, "[") || is(at_, "{")) at_ = closing(at_);
                if (++at_ >= tokens_.size()) fail(begin, "this statement does not end");
            }
            readCalls(begin, at_++, nodes);
        }
    }

    void readLoop(std::vector<Node>& nodes) {
        Node loop;
        loop.begin = tokens_[at_].begin;
        loop.counter = counter_++;
        const bool isDo = is(at_, "do"), isFor = is(at_, "for");
        std::size_t header = at_ + 1, body = at_ + 1;
        if (!isDo) {
            const std::size_t close = closing(header);
            std::size_t condition = header + 1;
            if (isFor) {
                while (!is(condition, ";"))
                    ++condition;
                readCalls(header + 1, condition, nodes);
                loop.constant = isConstant(header + 1, close);
            }
            readCalls(condition, close, loop.inner);
            body = close + 1;
        }
        at_ = body;
        readStatement(loop.inner);
        const bool isBlock = is(body, "{");
        insert(isBlock ? tokens_[body].end : tokens_[body].begin, (isBlock ? "" : "{") + count(loop.counter));
        if (!isBlock) insert(tokens_[at_ - 1].end, "}");
        if (isDo) {
            const std::size_t close = closing(at_ + 1);
            readCalls(at_ + 2, close, loop.inner);
            at_ = close + 2;
        }
        nodes.push_back(std::move(loop));
    }

    // True if the header of a `for` has constants only, besides its own variable.
    bool isConstant(std::size_t begin, std::size_t end) const {
        static const std::set<std::string> types{"int", "uint", "float"};
        std::string variable;
        for (std::size_t i = begin; i < end; ++i) {
            const std::string& word = tokens_[i].text;
            if (types.count(word) != 0 && isWordCharacter(tokens_[i + 1].text[0]))
                variable = tokens_[i + 1].text;
            else if (isWordCharacter(word[0]) && types.count(word) == 0 &&
                     std::isdigit(static_cast<unsigned char>(word[0])) == 0 && word != variable &&
                     constants_.count(word) == 0 && word.rfind("VCT_", 0) != 0)
                return false;
        }
        return !variable.empty();
    }

    static std::string count(std::size_t counter) { return " vctCount(" + std::to_string(counter) + "u); "; }
    void insert(std::size_t position, std::string text) {
        insertions_.emplace_back(position, std::move(text));
    }

    const std::vector<Node>* bodyOf(const Node& call) const {
        const std::vector<Node>* found = nullptr;
        for (auto [at, end] = functions_.equal_range(call.function); at != end; ++at) {
            if (at->second.parameters != call.arguments || at->second.body.empty()) continue;
            if (found != nullptr)
                throw Error("shaders/" + source_.files.front() + " calls " + call.function +
                            "(), of which two versions with as many parameters have loops; rename one");
            found = &at->second.body;
        }
        return found;
    }
    void list(const std::vector<Node>& nodes, int depth, std::vector<ShaderLoop>& loops) const {
        for (const Node& node : nodes) {
            if (!node.function.empty()) {
                if (const std::vector<Node>* body = bodyOf(node)) list(*body, depth, loops);
                continue;
            }
            loops.push_back({placeOf(node.begin), depth, node.constant, node.counter});
            list(node.inner, depth + 1, loops);
        }
    }

    // The file and line of a position, by the #line before it.
    std::string placeOf(std::size_t position) const {
        const std::size_t directive = source_.text.rfind("\n#line ", position);
        if (directive == std::string::npos) return source_.files.front();
        std::istringstream words(source_.text.substr(directive + 7, 32));
        std::size_t line = 0, file = 0;
        words >> line >> file;
        const std::size_t first = source_.text.find('\n', directive + 1) + 1;
        line += static_cast<std::size_t>(
            std::count(source_.text.begin() + static_cast<std::ptrdiff_t>(first),
                       source_.text.begin() + static_cast<std::ptrdiff_t>(std::max(first, position)), '\n'));
        return source_.files.at(file) + ":" + std::to_string(line);
    }

    void apply() {
        insert(source_.text.find("#line "),
               "layout(std430, binding = " + std::to_string(VCT_SSBO_COUNTERS) +
                   ") buffer VctCounters { uint vctCounters[]; };\n"
                   "void vctCount(uint counter) { atomicAdd(vctCounters[counter], 1u); }\n");
        std::stable_sort(insertions_.begin(), insertions_.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        // Insertions at one position are applied in reverse, so that the text of the last one comes first.
        for (const auto& [position, text] : insertions_)
            source_.text.insert(position, text);
    }

    gl::AssembledShader& source_;
    std::string active_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0, counter_;
    std::vector<Definition> definitions_;
    std::set<std::string> names_, constants_;
    std::multimap<std::string, Function> functions_;
    std::vector<std::pair<std::size_t, std::string>> insertions_;
};

}  // namespace

CountedShader countLoops(gl::AssembledShader& source, std::size_t firstCounter) {
    return Reader(source, firstCounter).read();
}

}  // namespace vct
