#include "core/trace.h"

namespace vct {

namespace {
TraceFunctions trace;
}

void setTraceFunctions(TraceFunctions functions) {
    trace = functions;
}

TraceSection::TraceSection(const char* name) {
    if (trace.begin != nullptr) trace.begin(name);
}

TraceSection::~TraceSection() {
    if (trace.end != nullptr) trace.end();
}

}  // namespace vct
