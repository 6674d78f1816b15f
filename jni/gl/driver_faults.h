// Known driver faults that can only be avoided by identifying the driver. Faults with a cheap workaround for
// all drivers are handled at the affected line, with their source.
#pragma once

#include <string>

namespace vct::gl {

// Each member describes a fault with its source, or is "" if no fault is known.
struct DriverFaults {
    std::string timerQueries;        // GL_EXT_disjoint_timer_query must not be used
    std::string derivatives;         // dFdx, dFdy and fwidth are wrong
    std::string indirectDispatches;  // they read the values before those that shaders wrote
};

// The faults of a driver, by GL_RENDERER and GL_VERSION. ANGLE has none here, because it works around the
// faults of the driver below it.
DriverFaults faultsOf(const std::string& renderer, const std::string& version);

}  // namespace vct::gl
