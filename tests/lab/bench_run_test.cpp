// A benchmark inside of a frame loop answers soon, whatever it does.
#include "lab/bench_run.h"

#include <gtest/gtest.h>

#include <set>

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
    const GlSpy<&gl::UseProgram> uses([&](GLuint program) { firstUses += used.insert(program).second; });
    int linkedByOneRun = 0;
    for (const char* repeat : {"1", "2"}) {
        BenchRun::Input input{
            benchRequestFromText(std::string("bench preset=mobile grid=64 size=16x16 shadow-map=64 repeat=") +
                                 repeat),
            scene,
            chooseLight(*scene),
            {},
            context.capabilities,
            testShaders(),
            "egl",
            {},
            [](const std::string&) {}};
        BenchRun run(input, "");
        used.clear();
        bool isComplete = false;
        int linkedBefore = linked;
        const int linkedAtStart = linked;
        while (!isComplete) {
            firstUses = 0;
            isComplete = !run.advance();
            EXPECT_LE(linked - linkedBefore + firstUses, 1);
            linkedBefore = linked;
        }
        if (linkedByOneRun == 0) linkedByOneRun = linked - linkedAtStart;
        EXPECT_EQ(linked - linkedAtStart, linkedByOneRun) << "a second renderer links programs again";
    }
    EXPECT_GT(linkedByOneRun, 10);
}

}  // namespace
}  // namespace vct::test
