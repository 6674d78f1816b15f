// What is asked of GL: every call through the table of api.h, for tests and for `vct info`.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gl/api.h"

namespace vct::gl {

struct Call {
    const char* name;                     // as in api.h, "DrawElements"
    std::vector<std::int64_t> arguments;  // numbers and names of objects; addresses for pointers
    std::string text;                     // of the last argument that is text
    // The objects that Delete... names, and the attachments that InvalidateFramebuffer names.
    std::vector<GLuint> names = {};
};

// Records all calls from its constructor to its destructor. One at a time; load() must have run.
class CallLog {
  public:
    CallLog();
    ~CallLog();
    CallLog(const CallLog&) = delete;
    CallLog& operator=(const CallLog&) = delete;

    const std::vector<Call>& calls() const { return calls_; }
    void clear() { calls_.clear(); }
    void add(Call call) { calls_.push_back(std::move(call)); }

  private:
    std::vector<Call> calls_;
};

struct CallSummary {
    int calls = 0;  // debug groups are none: they are names for people
    std::map<std::string, int> byName;
    // By the innermost debug group that they are made in, in the order in which these begin; "" for none.
    std::vector<std::pair<std::string, int>> byGroup;
    std::set<std::string> passes;  // the groups that are in no other
    int draws = 0, dispatches = 0;
    std::set<std::int64_t> programs;  // used for any of them
    // What shaders are given: "texture 3: GL_TEXTURE_2D", "uniform buffer 1: 208 bytes", each once. Objects
    // have no names here: they differ between two renderers that do the same.
    std::set<std::string> bindings;
};
CallSummary summaryOf(const std::vector<Call>& calls);

}  // namespace vct::gl
