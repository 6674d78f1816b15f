#include "core/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "core/error.h"
#include "core/number_text.h"

namespace vct {

namespace {

constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();

// Memory for the driver and its shader compiler besides the textures. They end the process if an allocation
// fails.
constexpr std::size_t driverReserve = std::size_t{384} << 20;

// The value of MemAvailable in /proc/meminfo.
std::size_t freeMemory() {
    std::ifstream file("/proc/meminfo");
    std::string key, unit;
    std::size_t kilobytes = 0;
    while (file >> key >> kilobytes) {
        std::getline(file, unit);
        if (key == "MemAvailable:") return kilobytes * 1024;
    }
    return unknown;
}

// Address space left below the limit of `ulimit -v`.
std::size_t freeAddressSpace() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknown;
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const std::size_t used = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return limit.rlim_cur > used ? static_cast<std::size_t>(limit.rlim_cur) - used : 0;
}

std::size_t freeBytes() {
    return std::min(freeMemory(), freeAddressSpace());
}

}  // namespace

std::size_t availableMemory() {
    const std::size_t available = freeBytes();
    return available > driverReserve ? available - driverReserve : 0;
}

void requireMemory(std::size_t bytes, const std::string& what) {
    const std::size_t available = freeBytes();
    if (bytes + driverReserve > available)
        throw Error("not enough memory for " + what + ": " +
                    (bytes == 0 ? "it needs " : "it needs " + megabytesText(bytes) + " and ") +
                    megabytesText(driverReserve) + " for the driver, and " + megabytesText(available) +
                    " are available; use fewer voxels (a coarser grid), or free memory");
}

void requireMainMemory(std::size_t bytes, const std::string& what, const std::string& remedy) {
    const std::size_t available = freeBytes();
    if (bytes > available)
        throw Error("not enough memory for " + what + ": it needs " + megabytesText(bytes) + ", and " +
                    megabytesText(available) + " are available; " + remedy + ", or free memory");
}

}  // namespace vct
