// How much main memory a request may take, for drivers whose textures live there: the kernel promises more
// than there is and ends the process later, so asking first is the only clear error.
#pragma once

#include <cstddef>
#include <string>

namespace vct {

// Bytes that textures and buffers may take: what is free, less what the driver takes besides. As many as
// there can be where the system does not tell.
std::size_t availableMemory();

// Throws vct::Error naming `what`, the bytes it needs, those there are and the remedy. Does nothing where the
// system does not tell.
void requireMemory(std::size_t bytes, const std::string& what);

// Likewise of what is no driver's: throws where `bytes` more than are available are asked for. `remedy`: what
// to do about it besides freeing memory.
void requireMainMemory(std::size_t bytes, const std::string& what, const std::string& remedy);

}  // namespace vct
