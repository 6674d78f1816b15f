// Decides if a driver meets the engine's requirements. The only input is the driver's report, so that tests
// can invent drivers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gl/api.h"
#include "gl/capabilities.h"

namespace vct::gl {

struct DriverReport {
    std::string version;                       // GL_VERSION
    std::vector<std::string> extensions;       // GL_EXTENSIONS
    bool essl310 = false, essl320 = false;     // a probe shader of that version compiles
    std::function<GLint(GLenum limit)> limit;  // glGetIntegerv
};

Limits limitsOf(const std::function<GLint(GLenum limit)>& limit);
std::vector<Requirement> evaluateRequirements(const DriverReport& driver);

// True for renderers that run on the CPU, also through another driver: "zink (llvmpipe ...)".
bool isSoftwareRenderer(const std::string& renderer);

}  // namespace vct::gl
