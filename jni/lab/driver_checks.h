// The single assumptions about a driver that the presets mobile and quality stand on and that no program of
// phones is known to have relied on before. The preset thesis stands on what the thesis's own app did on a
// Galaxy S7 in 2016.
#pragma once

#include <string>
#include <vector>

#include "gl/program.h"

namespace vct {

// All of them, each followed by an indirect dispatch of the size that it wrote. Returns the first that does
// not hold, with what was found, or "". Throws what making the programs throws.
std::string failedAssumption(const gl::ShaderLibrary& shaders);

std::vector<gl::ProgramDescription> driverCheckPrograms();

}  // namespace vct
