// A benchmark inside of a frame loop answers soon, whatever it does.
#include "lab/bench_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "scene/light_choice.h"
#include "support/gl_spy.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

// A driver may take a tenth of a second for a program, when it is linked or first used.
TEST(BenchRun, HasOneNewProgramInEachPart) {
    const Context context = openContext(Backend::egl);
    const auto scene = std::make_shared<const Scene>(loadGltf(asset("cornell.glb")));
    std::set<GLuint> used;
    int linked = 0, firstUses = 0;
    const GlSpy<&gl::LinkProgram> links([&](GLuint) { ++linked; });
    // The last pass of each mode takes the longest to compile, so the part that first uses it has no more to
    // do than to voxelize: ten dispatches, and not the thirty with a step of light.
    std::set<GLuint> lastPasses;
    int dispatches = 0;
    bool usesNewLastPass = false;
    const GlSpy<&gl::UseProgram> uses([&](GLuint program) {
        const bool isNew = used.insert(program).second;
        firstUses += isNew;
        usesNewLastPass |= isNew && lastPasses.count(program) > 0;
    });
    bool makesVoxels = false;
    const GlSpy<&gl::TexStorage3D> textures(
        [&](GLenum, GLsizei, GLenum, GLsizei width, GLsizei height, GLsizei depth) {
            makesVoxels |= std::min({width, height, depth}) >= 64;
        });
    const GlSpy<&gl::ObjectLabel> labels([&](GLenum type, GLuint name, GLsizei, const GLchar* text) {
        if (type == GL_PROGRAM && std::string_view(text).starts_with("shade ")) lastPasses.insert(name);
    });
    const GlSpy<&gl::DispatchCompute> direct([&](GLuint, GLuint, GLuint) { ++dispatches; });
    const GlSpy<&gl::DispatchComputeIndirect> indirect([&](GLintptr) { ++dispatches; });
    BenchRun::Input input{
        benchRequestFromText("bench preset=mobile grid=64 size=16x16 shadow-map=64 repeat=2"),
        scene,
        chooseLight(*scene),
        {},
        context.capabilities,
        testShaders(),
        "egl",
        {},
        [](const std::string&) {}};
    BenchRun run(input, "");
    bool isComplete = false;
    int linkedByFirst = 0, linkedBefore = 0, newLastPasses = 0;
    while (!isComplete) {
        firstUses = 0;
        makesVoxels = usesNewLastPass = false;
        dispatches = 0;
        isComplete = !run.advance();
        EXPECT_LE(linked - linkedBefore + firstUses, 1);
        EXPECT_FALSE(makesVoxels && run.renderer() != nullptr) << "a frame also voxelizes static geometry";
        EXPECT_TRUE(!usesNewLastPass || dispatches <= 10) << dispatches;
        newLastPasses += usesNewLastPass;
        linkedBefore = linked;
        if (run.progress().find("run 1 of 2") != std::string::npos) linkedByFirst = linked;
    }
    EXPECT_EQ(newLastPasses, 5);
    EXPECT_GT(linkedByFirst, 10);
    EXPECT_EQ(linked, linkedByFirst) << "a second renderer links programs again";
}

}  // namespace
}  // namespace vct::test
