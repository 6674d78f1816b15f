#include "core/memory_grant.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

namespace vct {

std::optional<std::size_t> bytesOf(const std::string& key, const std::string& file) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string found;
        std::size_t kilobytes = 0;
        if (words >> found >> kilobytes && found == key + ":") return kilobytes * 1024;
    }
    return {};
}

std::size_t memoryGrantLeft(const std::string& meminfo, const std::string& status) {
    const std::optional<std::size_t> total = bytesOf("MemTotal", meminfo);
    if (!total) return std::numeric_limits<std::size_t>::max();
    const std::size_t used = bytesOf("VmRSS", status).value_or(0) + bytesOf("VmSwap", status).value_or(0);
    return *total / 2 - std::min(*total / 2, used);
}

}  // namespace vct
