// Checks, one by one, the assumptions about a driver that the presets make and that few or no other programs
// on phones are known to make. The preset thesis assumes only what the thesis's own app used on a Galaxy S7
// in 2016: of these, atomics of fragments on a 3D image.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gl/program.h"

namespace vct {

struct DriverCheck {
    // Checks one assumption, and that an indirect dispatch has the size that it wrote. Returns "", or the
    // assumption that failed with the values that were found. Throws vct::Error if a program does not
    // compile.
    std::function<std::string(const gl::ShaderLibrary& shaders)> run;
    bool isNeededByThesis = false;
};
// `pixelSamples`: see pixelSamplesFor() in engine/voxelization.h.
std::vector<DriverCheck> driverChecks(int pixelSamples);

std::vector<gl::ProgramDescription> driverCheckPrograms();

}  // namespace vct
