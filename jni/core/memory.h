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

// Returns the bytes that an app of Android can still take: half of the device's memory, less what it holds
// already; the largest possible number if the files do not tell. `meminfo`: /proc/meminfo; `status`:
// /proc/self/status.
//
// Android tells no limit of native memory (getMemoryClass() is the limit of Java's heap). What is free is
// none either: Android keeps the apps in memory that the user has left, and its low-memory killer (lmkd) ends
// them when the app on the screen needs their memory, and that app last. Half of the memory remains for the
// kernel, the system's services, the launcher and the keyboard, which it does not end.
std::size_t memoryGrantLeft(const std::string& meminfo, const std::string& status);

// Returns the bytes that are left in this process's container; the largest possible number if it has no
// limit. Cached files that the kernel would drop count as left. `root`: the folder of control groups
// (/sys/fs/cgroup), where a container sees its own group.
std::size_t freeContainerMemory(const std::string& root);

}  // namespace vct
