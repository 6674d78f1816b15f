// Faults of real drivers that a program can only go around by knowing whose driver it runs on. Those that
// have a cheap way around for every driver are dealt with where they occur, each with its source at the line.
#pragma once

#include <string>

namespace vct::gl {

// What is wrong, and who says so; "" where nothing is known.
struct DriverFaults {
    std::string timerQueries;  // GL_EXT_disjoint_timer_query is not to be used
    std::string derivatives;   // dFdx, dFdy and fwidth are not to be believed
};

// By GL_RENDERER and GL_VERSION. ANGLE has its own ways around the faults of what is below it.
DriverFaults faultsOf(const std::string& renderer, const std::string& version);

}  // namespace vct::gl
