// Named sections on a system-wide timeline (Android's ATrace, shown by Perfetto). Nothing happens until
// somebody says who records them.
#pragma once

namespace vct {

// Sections nest and end in the reverse order on the thread that began them.
struct TraceFunctions {
    void (*begin)(const char* name) = nullptr;
    void (*end)() = nullptr;
};
void setTraceFunctions(TraceFunctions functions);

class TraceSection {
  public:
    explicit TraceSection(const char* name);
    ~TraceSection();
    TraceSection(const TraceSection&) = delete;
    TraceSection& operator=(const TraceSection&) = delete;
};

}  // namespace vct
