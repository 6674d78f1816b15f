// Files are written whole or not at all, and no other file changes.
#include "core/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include "support/errors.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

using FileNames = std::vector<std::string>;

TEST(ReplaceFile, FollowsNoLinkThatIsNamedLikeATemporaryFile) {
    const TemporaryFolder folder;
    writeBytes(folder.file("mine"), "mine");
    std::filesystem::create_symlink("mine", folder.file("a.png.tmp"));
    replaceFile(folder.file("a.png"), "a picture");
    EXPECT_EQ(readBytes(folder.file("mine")), "mine");
    EXPECT_EQ(readBytes(folder.file("a.png")), "a picture");
    EXPECT_EQ(folder.list(), (FileNames{"a.png", "a.png.tmp", "mine"}));
}

TEST(ReplaceFile, ReplacesNothingThatIsNoFile) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo(folder.file("pipe").c_str(), 0600), 0);
    expectMentions(errorOf([&] { replaceFile(folder.file("pipe"), "text"); }), {"pipe", "not a file"});
    EXPECT_TRUE(std::filesystem::is_fifo(folder.file("pipe")));
    EXPECT_EQ(folder.list(), FileNames{"pipe"});
}

TEST(ReplaceFile, ManyAtOnceDoNotDisturbEachOther) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a");
    std::vector<std::string> errors(8);
    std::vector<std::thread> writers;
    for (std::string& error : errors)
        writers.emplace_back([&] {
            error = errorOf([&] {
                for (int i = 0; i < 100; ++i)
                    replaceFile(path, std::string(1000, 'x'));
            });
        });
    for (std::thread& writer : writers)
        writer.join();
    for (const std::string& error : errors)
        EXPECT_EQ(error, "");
    EXPECT_EQ(readBytes(path), std::string(1000, 'x'));
    EXPECT_EQ(folder.list(), FileNames{"a"});
}

TEST(ReplaceFile, ALackOfSpaceLeavesTheOldFileAndNoOther) {
    const TemporaryFolder folder;
    writeBytes(folder.file("a"), "of yesterday");
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = before;
    small.rlim_cur = 4096;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string error = errorOf([&] { replaceFile(folder.file("a"), std::string(10000, 'x')); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    expectMentions(error, {"cannot write", "File too large"});
    EXPECT_EQ(readBytes(folder.file("a")), "of yesterday");
    EXPECT_EQ(folder.list(), FileNames{"a"});
}

}  // namespace
}  // namespace vct::test
