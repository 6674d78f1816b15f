// Checks, one by one, the assumptions about a driver that the presets mobile and quality make and that no
// other program on phones is known to make. The preset thesis assumes only what the thesis's own app used on
// a Galaxy S7 in 2016.
#pragma once

#include <string>
#include <vector>

#include "gl/program.h"

namespace vct {

// Checks all assumptions, each followed by an indirect dispatch of the size that it wrote. Returns the first
// one that fails, with the values that were found, or "". Throws vct::Error if a program does not compile.
std::string failedAssumption(const gl::ShaderLibrary& shaders);

std::vector<gl::ProgramDescription> driverCheckPrograms();

}  // namespace vct
