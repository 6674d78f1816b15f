// The program leaves no temporary files and overwrites no files of the user.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "cli/program_run.h"
#include "support/errors.h"

namespace vct::test {
namespace {

std::string renderIntoOut(const std::string& options) {
    return std::string("render ") + ProgramRun::cornell + " --size 16x16 --grid 64 --mode phong --out out " +
           options;
}

TEST(Output, FilesNamedLikeTemporaryOnesStay) {
    ProgramRun program;
    std::filesystem::create_directory(program.folder.file("out"));
    for (const char* name : {"out/vct.tmp", "out/phong.png.tmp", "t.json.tmp"})
        writeBytes(program.folder.file(name), "mine");
    EXPECT_EQ(program.run("render none.glb --out out --timings t.json"), 1);
    EXPECT_EQ(program.folder.list("out"), (std::vector<std::string>{"phong.png.tmp", "vct.tmp"}));
    program.expectSuccess(renderIntoOut("--timings t.json"));
    for (const char* name : {"out/vct.tmp", "out/phong.png.tmp", "t.json.tmp"})
        EXPECT_EQ(readBytes(program.folder.file(name)), "mine") << name;
}

TEST(Output, APipeIsNotReplaced) {
    ProgramRun program;
    ASSERT_EQ(mkfifo(program.folder.file("pipe").c_str(), 0600), 0);
    EXPECT_EQ(program.run(renderIntoOut("--timings pipe")), 1);
    expectMentions(program.err, {"cannot write 'pipe'", "not a file"});
    EXPECT_TRUE(std::filesystem::is_fifo(program.folder.file("pipe")));
}

TEST(Output, AnInterruptedRunLeavesNothing) {
    ProgramRun program;
    const std::string slow = std::string("render ") + ProgramRun::cornell +
                             " --size 2000x2000 --preset quality --mode gi --out deep/er/out";
    EXPECT_EQ(program.run(slow, "timeout 2"), 124) << program.err;
    EXPECT_EQ(program.folder.list(), std::vector<std::string>{});
}

}  // namespace
}  // namespace vct::test
