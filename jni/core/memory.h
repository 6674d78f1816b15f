// Checks that a request fits into main memory, for drivers that keep textures there. The kernel grants more
// memory than exists and ends the process later, so only a check beforehand gives a clear error.
#pragma once

#include <cstddef>
#include <string>

namespace vct {

// Bytes available to textures and buffers: the free memory less the driver's own needs. The largest possible
// number if the system does not tell.
std::size_t availableMemory();

// The remedy if too little is available: "free memory", or to raise the limit that is the tightest.
const char* memoryRemedy();

// Throws vct::Error if no driver can be loaded: too little address space is left, or the system starts no
// threads. Called before a driver is loaded, because drivers end the process in these cases.
void requireDriver();

// Throws vct::Error naming `what`, the needed and the available bytes and the remedy, if textures and buffers
// of `bytes` do not fit beside the driver's own needs. Does nothing if the system does not tell how much
// memory is free.
void requireMemory(std::size_t bytes, const std::string& what);

// The same check for memory that the program itself allocates, without the driver's share. `remedy` is the
// advice in the message besides memoryRemedy().
void requireMainMemory(std::size_t bytes, const std::string& what, const std::string& remedy);

}  // namespace vct
