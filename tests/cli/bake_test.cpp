// vct bake keeps the light of a scene in a file, which vct render takes, or refuses with the reason.
#include <gtest/gtest.h>

#include "cli/program_run.h"
#include "core/files.h"
#include "support/errors.h"
#include "support/moving_scenes.h"

namespace vct::test {
namespace {

TEST(Bake, WritesLightThatIsTakenOrRefusedWithTheReason) {
    ProgramRun program;
    const Bytes scene = openFloor().glb();
    replaceFile(program.folder.file("my.glb"), {scene.begin(), scene.end()});
    EXPECT_EQ(program.run("bake my.glb --preset thesis"), 1);
    expectMentions(program.err, {"error: the preset thesis has no light to bake; use mobile or quality"});
    program.expectSuccess("bake my.glb");
    expectMentions(program.err, {"wrote my.vctlight: the light of ", " MB"});
    EXPECT_EQ(program.folder.list(), (std::vector<std::string>{"my.glb", "my.vctlight"}));

    const std::string render = "render my.glb --size 16x16 --out my.png --baked-light ";
    program.expectSuccess(render + "my.vctlight");
    const std::string light = readBytes(program.folder.file("my.vctlight"));
    replaceFile(program.folder.file("short.vctlight"), light.substr(0, light.size() / 2));
    const std::pair<const char*, const char*> refused[] = {
        {"none.vctlight", "none.vctlight"},
        {"my.glb", "--baked-light my.glb is no baked light; make one with `vct bake`"},
        {"short.vctlight", "--baked-light short.vctlight is truncated or damaged; bake it again"},
        {"my.vctlight --sky 1", "--baked-light my.vctlight is baked light of other sky; bake it again"},
        {"my.vctlight --light intensity=1", "light of other lights, sky; bake it again"},
        {"my.vctlight --preset quality", "light of other settings; bake it again"}};
    for (const auto& [options, says] : refused) {
        EXPECT_EQ(program.run(render + options), 1) << options;
        expectMentions(program.err, {"error: ", says});
    }
}

}  // namespace
}  // namespace vct::test
