#include "core/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>

#include "core/error.h"
#include "core/number_text.h"
#include "core/one_line.h"

namespace vct {

namespace {

constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();

// Memory for the driver and its shader compiler besides the textures. They end the process if an allocation
// fails.
constexpr std::size_t driverReserve = std::size_t{384} << 20;

// The number of a line "KEY: NUMBER kB", in bytes; empty if the file or the line is missing.
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

// Address space left below the limit of `ulimit -v`.
std::size_t freeAddressSpace() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknown;
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const std::size_t used = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return limit.rlim_cur > used ? static_cast<std::size_t>(limit.rlim_cur) - used : 0;
}

struct MemoryLimit {
    std::size_t left;  // bytes
    const char* name;  // as in "5 MB are left of NAME"
    const char* remedy;
};

MemoryLimit tightestLimit() {
    const MemoryLimit limits[] = {
#ifdef __ANDROID__
        {memoryGrantLeft("/proc/meminfo", "/proc/self/status"),
         "the memory that Android grants an app (half of the device's)", "use a device with more memory"},
#else
        {bytesOf("MemAvailable", "/proc/meminfo").value_or(unknown), "the main memory", "free memory"},
#endif
        {freeAddressSpace(), "the address space that `ulimit -v` allows", "raise the limit of `ulimit -v`"},
        {freeContainerMemory("/sys/fs/cgroup"), "the memory that the container allows",
         "raise the container's limit"}};
    return *std::min_element(std::begin(limits), std::end(limits),
                             [](const MemoryLimit& a, const MemoryLimit& b) { return a.left < b.left; });
}

// Address space that a driver takes before it draws: the libraries, and for each thread a stack and a heap.
// Measured with llvmpipe of Mesa 22: 311 MB on one core, 606 MB on two, 1360 MB with eight threads and 1491
// MB with 16.
std::size_t driverAddressSpace() {
    const std::size_t threads = std::clamp(std::thread::hardware_concurrency(), 1U, 9U);
    return (std::size_t{400} + 128 * threads) << 20;
}

std::string leftOf(const MemoryLimit& limit) {
    return megabytesText(limit.left) + " are left of " + limit.name;
}

}  // namespace

std::size_t memoryGrantLeft(const std::string& meminfo, const std::string& status) {
    const std::optional<std::size_t> total = bytesOf("MemTotal", meminfo);
    if (!total) return unknown;
    const std::size_t used = bytesOf("VmRSS", status).value_or(0) + bytesOf("VmSwap", status).value_or(0);
    return *total / 2 - std::min(*total / 2, used);
}

std::size_t freeContainerMemory(const std::string& root) {
    // The files differ between the versions of control groups.
    for (const auto& [limitFile, usageFile, droppableKey] :
         {std::array{"/memory.max", "/memory.current", "inactive_file"},
          std::array{"/memory/memory.limit_in_bytes", "/memory/memory.usage_in_bytes",
                     "total_inactive_file"}}) {
        std::size_t limit = 0, usage = 0;
        // Without a limit the file is absent or holds the word "max".
        if (!(std::ifstream(root + limitFile) >> limit)) continue;
        std::ifstream(root + usageFile) >> usage;
        std::ifstream stat(std::filesystem::path(root + limitFile).replace_filename("memory.stat"));
        std::string key;
        for (std::size_t value = 0; stat >> key >> value;)
            if (key == droppableKey) usage -= std::min(usage, value);
        return limit - std::min(limit, usage);
    }
    return unknown;
}

std::size_t availableMemory() {
    const std::size_t available = tightestLimit().left;
    return available > driverReserve ? available - driverReserve : 0;
}

const char* memoryRemedy() {
    return tightestLimit().remedy;
}

void requireDriver() {
    const std::size_t needed = driverAddressSpace() + driverReserve, left = freeAddressSpace();
    if (left < needed)
        throw Error("not enough memory for an OpenGL driver: it needs " + megabytesText(needed) +
                    " of address space, and " + megabytesText(left) +
                    " are left; raise the limit of `ulimit -v`");
    try {
        std::thread([] {}).join();
    } catch (const std::system_error& error) {
        throw Error(
            "the system starts no thread for an OpenGL driver (" + asClause(error.what()) +
            "); raise the limits of processes (`ulimit -u`) and address space (`ulimit -v`), or lower "
            "that of the stack (`ulimit -s`)");
    }
}

void requireMemory(std::size_t bytes, const std::string& what) {
    const MemoryLimit limit = tightestLimit();
    if (bytes + driverReserve <= limit.left) return;
    throw Error("not enough memory for " + what + ": " +
                (bytes == 0 ? "it needs " : "it needs " + megabytesText(bytes) + " and ") +
                megabytesText(driverReserve) + " for the driver, and " + leftOf(limit) + "; " +
                (bytes == 0 ? "" : "use fewer voxels (a coarser grid), or ") + limit.remedy);
}

void requireMainMemory(std::size_t bytes, const std::string& what, const std::string& remedy) {
    const MemoryLimit limit = tightestLimit();
    if (bytes > limit.left)
        throw Error("not enough memory for " + what + ": it needs " + megabytesText(bytes) + ", and " +
                    leftOf(limit) + "; " + remedy + ", or " + limit.remedy);
}

}  // namespace vct
