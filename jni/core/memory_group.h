// The memory limit of control groups (cgroups), which containers set.
#pragma once

#include <cstddef>
#include <string>

namespace vct {

// Returns the bytes that are left in the control groups of this process and their parents, of version 1 or 2;
// the largest possible number if none has a limit. Cached files that the kernel would drop count as left.
// `membership`: /proc/self/cgroup; `root`: the folder of the groups.
std::size_t freeGroupMemory(const std::string& membership, const std::string& root);

}  // namespace vct
