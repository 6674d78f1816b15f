#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "core/memory_grant.h"
#include "core/memory_group.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

constexpr std::size_t noLimit = std::numeric_limits<std::size_t>::max();

// A folder of control groups.
struct Groups {
    TemporaryFolder folder;

    void write(const std::string& name, const std::string& text) const {
        const std::filesystem::path path(folder.file(name));
        std::filesystem::create_directories(path.parent_path());
        writeBytes(path.string(), text);
    }
    std::size_t freeMemory() const { return freeGroupMemory(folder.file("membership"), folder.path()); }
};

TEST(ControlGroups, TheTightestLimitOfAGroupAndItsParentsCounts) {
    Groups groups;
    EXPECT_EQ(groups.freeMemory(), noLimit);
    groups.write("membership", "0::/outer/inner\n");
    EXPECT_EQ(groups.freeMemory(), noLimit);
    groups.write("outer/inner/memory.max", "max\n");
    groups.write("outer/memory.max", "1000\n");
    groups.write("outer/memory.current", "700\n");
    EXPECT_EQ(groups.freeMemory(), 300U);
    groups.write("outer/memory.stat", "anon 5\ninactive_file 200\nactive_file 9\n");
    EXPECT_EQ(groups.freeMemory(), 500U);
    groups.write("outer/inner/memory.max", "400\n");
    groups.write("outer/inner/memory.current", "500\n");
    EXPECT_EQ(groups.freeMemory(), 0U);
}

TEST(ControlGroups, OfVersion1AreReadFromTheirOwnFolder) {
    Groups groups;
    groups.write("membership", "5:devices:/a\n4:cpu,memory:/a/b\n0::/\n");
    groups.write("memory/a/memory.limit_in_bytes", "1000\n");
    groups.write("memory/a/memory.usage_in_bytes", "400\n");
    groups.write("memory/a/memory.stat", "cache 300\ntotal_inactive_file 100\n");
    EXPECT_EQ(groups.freeMemory(), 700U);
    // A container may see its own group as the root only.
    Groups inside;
    inside.write("membership", "4:memory:/docker/0123\n");
    inside.write("memory/memory.limit_in_bytes", "1000\n");
    inside.write("memory/memory.usage_in_bytes", "1\n");
    EXPECT_EQ(inside.freeMemory(), 999U);
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
