// tools/make_assets.py makes the scenes in assets/ again, byte for byte.
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/temporary_folder.h"

namespace vct {
namespace {

TEST(Assets, RegenerateToTheSameBytes) {
    if (std::system("python3 -c 'pass' 2>/dev/null") != 0) GTEST_SKIP() << "no python3 here";
    const TemporaryFolder folder;
    const std::string source = VCT_SOURCE_DIR;
    const std::string command = "python3 '" + source + "/tools/make_assets.py' --out '" + folder.path() + "'";
    ASSERT_EQ(std::system((command + " > /dev/null").c_str()), 0) << command;
    std::size_t compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source + "/assets")) {
        if (entry.path().extension() != ".glb" && entry.path().extension() != ".hdr") continue;
        const std::string name = entry.path().filename().string();
        const std::string committed = readBytes(entry.path().string());
        EXPECT_LT(committed.size(), 1024U * 1024U) << name;
        EXPECT_TRUE(committed == readBytes(folder.file(name))) << name << " differs; run " << command;
        ++compared;
    }
    EXPECT_GE(compared, 9U);
    EXPECT_EQ(folder.list().size(), compared);
}

}  // namespace
}  // namespace vct
