// Records all GL calls through the table of api.h, for tests and for `vct info`.
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
    const char* name;                     // as in api.h: "DrawElements"
    std::vector<std::int64_t> arguments;  // numbers, or addresses for pointers
    std::string text;                     // the last text argument
    // The object names passed to Delete..., or the attachments passed to InvalidateFramebuffer.
    std::vector<GLuint> names = {};
};

// Records all calls from its constructor to its destructor. Only one may exist at a time; load() must have
// run.
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
    int calls = 0;  // without the calls for debug groups
    std::map<std::string, int> byName;
    // Calls by innermost debug group, in the order in which the groups begin; "" for calls outside of groups.
    std::vector<std::pair<std::string, int>> byGroup;
    std::set<std::string> passes;  // the outermost groups
    int draws = 0, dispatches = 0;
    std::set<std::int64_t> programs;  // programs of draws and dispatches
    // Bindings, such as "texture 3: GL_TEXTURE_2D" or "uniform buffer 1: 208 bytes", each once. Object names
    // are left out, because they differ between renderers that do the same.
    std::set<std::string> bindings;
};
CallSummary summarize(const std::vector<Call>& calls);

}  // namespace vct::gl
