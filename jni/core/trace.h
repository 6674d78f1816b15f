// Named sections on a system-wide timeline (Android's ATrace, shown by Perfetto). Nothing happens until
// somebody says who records them.
#pragma once

namespace vct {

// Sections nest and end in the reverse order on the thread that began them.
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
