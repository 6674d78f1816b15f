// Checks, one by one, the assumptions about a driver that the presets mobile and quality make and that no
// other program on phones is known to make. The preset thesis assumes only what the thesis's own app used on
// a Galaxy S7 in 2016.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gl/program.h"

namespace vct {

// Each checks one assumption, and that an indirect dispatch has the size that it wrote. Returns "", or the
// assumption that failed with the values that were found. Throws vct::Error if a program does not compile.
using DriverCheck = std::function<std::string(const gl::ShaderLibrary& shaders)>;
const std::vector<DriverCheck>& driverChecks();

std::vector<gl::ProgramDescription> driverCheckPrograms();

}  // namespace vct
