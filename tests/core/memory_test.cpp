#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "core/memory.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

constexpr std::size_t noLimit = std::numeric_limits<std::size_t>::max();

TEST(MemoryOfAContainer, IsWhatItsLimitLeaves) {
    struct Names {
        const char *folder, *limit, *usage, *droppable;
    };
    for (const Names& names :
         {Names{"", "memory.max", "memory.current", "inactive_file"},
          Names{"/memory", "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"}}) {
        const TemporaryFolder root;
        const std::string folder = root.path() + names.folder + "/";
        std::filesystem::create_directories(folder);
        const auto left = [&] { return freeContainerMemory(root.path()); };
        EXPECT_EQ(left(), noLimit);
        writeBytes(folder + names.limit, "max\n");
        EXPECT_EQ(left(), noLimit);
        writeBytes(folder + names.limit, "1000\n");
        writeBytes(folder + names.usage, "700\n");
        EXPECT_EQ(left(), 300U);
        writeBytes(folder + "memory.stat",
                   std::string("anon 5\n") + names.droppable + " 200\nactive_file 9\n");
        EXPECT_EQ(left(), 500U);
        writeBytes(folder + names.usage, "1300\n");
        EXPECT_EQ(left(), 0U);
    }
}

TEST(MemoryOfAnApp, IsHalfOfTheDevicesLessItsOwn) {
    const TemporaryFolder folder;
    const auto left = [&] { return memoryGrantLeft(folder.file("meminfo"), folder.file("status")); };
    EXPECT_EQ(left(), noLimit);
    // A phone of 2 GB whose memory is full of apps that Android ends as needed.
    writeBytes(folder.file("meminfo"),
               "MemTotal:        1900000 kB\nMemFree:           40000 kB\nMemAvailable:     200000 kB\n");
    EXPECT_EQ(left(), std::size_t{950000} * 1024);
    writeBytes(folder.file("status"),
               "Name:\tvct.app\nState:\tR (running)\nVmRSS:\t  300000 kB\nVmSwap:\t   50000 kB\n");
    EXPECT_EQ(left(), std::size_t{600000} * 1024);
    writeBytes(folder.file("status"), "VmRSS:\t  990000 kB\n");
    EXPECT_EQ(left(), 0U);
}

}  // namespace
}  // namespace vct::test
