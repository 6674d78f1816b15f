// Named sections on a system-wide timeline (Android's ATrace, shown by Perfetto). They do nothing until
// traceFunctions is set.
#pragma once

namespace vct {

// The recorder's functions. Sections nest; a section ends on the thread that began it.
struct TraceFunctions {
    void (*begin)(const char* name) = nullptr;
    void (*end)() = nullptr;
};
inline TraceFunctions traceFunctions;

class TraceSection {
  public:
    explicit TraceSection(const char* name) {
        if (traceFunctions.begin != nullptr) traceFunctions.begin(name);
    }
    ~TraceSection() {
        if (traceFunctions.end != nullptr) traceFunctions.end();
    }
    TraceSection(const TraceSection&) = delete;
    TraceSection& operator=(const TraceSection&) = delete;
};

}  // namespace vct
