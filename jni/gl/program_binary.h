// Compiled programs that an earlier run has kept.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gl/api.h"

namespace vct::gl {

// The key of a program with these sources, which the driver of the current context has compiled.
std::string programKey(const std::vector<std::string>& sources);

// True if the driver can return compiled programs.
bool hasProgramBinaries();
// Returns what the driver has compiled; empty if it fails.
std::vector<std::uint8_t> programBinary(GLuint program);
// Makes the program what was compiled earlier. Returns false if the bytes were changed, or if the driver
// refuses them, as it does after an update.
bool loadProgramBinary(GLuint program, const std::vector<std::uint8_t>& binary);

}  // namespace vct::gl
