// Numbers of /proc, and the memory that Android grants an app.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace vct {

// The number of a line "KEY: NUMBER kB", in bytes; empty if the file or the line is missing.
std::optional<std::size_t> bytesOf(const std::string& key, const std::string& file);

// Returns the bytes that an app of Android can still take: half of the device's memory, less what it holds
// already; the largest possible number if the files do not tell. `meminfo`: /proc/meminfo; `status`:
// /proc/self/status.
//
// Android tells no limit of native memory (getMemoryClass() is the limit of Java's heap). What is free is
// none either: Android keeps the apps in memory that the user has left, and its low-memory killer (lmkd) ends
// them when the app on the screen needs their memory, and that app last. Half of the memory remains for the
// kernel, the system's services, the launcher and the keyboard, which it does not end.
std::size_t memoryGrantLeft(const std::string& meminfo, const std::string& status);

}  // namespace vct
