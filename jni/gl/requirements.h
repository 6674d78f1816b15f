// What the pipeline needs of a driver, decided from what the driver reports and from nothing else, so that a
// driver which lacks things can be made up in a test.
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

// True for the renderers that run on the CPU, also below another driver: "zink (llvmpipe ...)".
bool isSoftwareRenderer(const std::string& renderer);

}  // namespace vct::gl
