#include "core/memory_group.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

namespace vct {
namespace {

// The files of a group, which differ between the versions.
struct Files {
    const char *limit, *usage, *droppable;  // the last is a key of memory.stat
};
constexpr Files version1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
constexpr Files version2{"memory.max", "memory.current", "inactive_file"};

std::size_t freeIn(const std::string& folder, const Files& files) {
    std::size_t limit = 0, usage = 0, droppable = 0;
    // Without a limit the file is absent or holds the word "max".
    if (!(std::ifstream(folder + "/" + files.limit) >> limit)) return std::numeric_limits<std::size_t>::max();
    std::ifstream(folder + "/" + files.usage) >> usage;
    std::ifstream stat(folder + "/memory.stat");
    std::string key;
    for (std::size_t value = 0; stat >> key >> value;)
        if (key == files.droppable) droppable = value;
    const std::size_t used = usage - std::min(usage, droppable);
    return limit - std::min(limit, used);
}

}  // namespace

std::size_t freeGroupMemory(const std::string& membership, const std::string& root) {
    std::size_t free = std::numeric_limits<std::size_t>::max();
    std::ifstream lines(membership);
    // A line is "4:memory:/path", or "0::/path" of version 2.
    for (std::string line; std::getline(lines, line);) {
        std::istringstream parts(line);
        std::string number, controllers, path;
        std::getline(parts, number, ':');
        std::getline(parts, controllers, ':');
        std::getline(parts, path);
        const bool isMemory = ("," + controllers + ",").find(",memory,") != std::string::npos;
        if (!isMemory && !controllers.empty()) continue;
        // In a container the path may be the one outside, of which only the root is visible.
        for (;; path.erase(path.find_last_of('/'))) {
            free = std::min(
                free, isMemory ? freeIn(root + "/memory" + path, version1) : freeIn(root + path, version2));
            if (path.find('/') == std::string::npos) break;
        }
    }
    return free;
}

}  // namespace vct
