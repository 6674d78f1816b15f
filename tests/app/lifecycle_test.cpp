// The lifecycle of the app: when it draws, which objects it keeps and which it rebuilds.
#include <gtest/gtest.h>

#include "app/viewer.h"
#include "stand_in/stand_in.h"
#include "support/element_buffers.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

constexpr int width = 96;
constexpr int height = 64;

void expectClean(const StandIn& android) {
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

// The tests do not depend on the frames, so these are cheap.
class Small : public StandIn {
  public:
    Small() { intentExtra = "show grid=64 mode=ao pixels=2"; }
};

// The self-test leaves the programs of all presets, which go when memory is low.
TEST(Lifecycle, StartsTestsTheDriverShowsASceneAndEnds) {
    Small android;
    android.testsDriver = true;
    android.startUntilSceneShown(width, height);
    int before = 0;
    android.then([&] {
        before = liveGlObjects("Programs");
        android.capture = true;
    });
    android.command(APP_CMD_LOW_MEMORY);
    android.then([&] { EXPECT_LT(liveGlObjects("Programs"), before / 2); });
    android.frames(1);
    android.run();
    EXPECT_FALSE(android.screen.pixels.empty());
    EXPECT_GT(android.shown, 2);
    EXPECT_EQ(android.contextsMade, 1);
    EXPECT_TRUE(android.logged("self-test passed: ")) << android.errors();
    EXPECT_TRUE(app::passedSelfTest().has_value()) << "another activity of this process would repeat it";
    EXPECT_TRUE(android.logged("GL_OES_shader_image_atomic")) << "what `vct info` prints belongs in the log";
    EXPECT_TRUE(android.logged("the app ends"));
    expectClean(android);
}

TEST(Lifecycle, ADriverThatPassedIsNotTestedAgain) {
    Small android;
    android.startUntilSceneShown(width, height);
    android.run();
    EXPECT_TRUE(android.logged("self-test passed earlier in this process"));
    EXPECT_FALSE(android.logged("self-test passed: "));
    expectClean(android);
}

TEST(Lifecycle, DrawsOnlyWithAWindowAndWhileResumed) {
    Small android;
    int before = 0;
    const auto keep = [&] { before = android.shown; };
    const auto expectNoFrame = [&](const char* when) {
        android.frames(3);
        android.then([&, when] { EXPECT_EQ(android.shown, before) << when; });
    };
    android.command(APP_CMD_START);
    expectNoFrame("before a window");
    android.command(APP_CMD_RESUME);
    expectNoFrame("resumed, without a window");
    android.window(width, height);
    android.frames(3);
    android.then([&] { EXPECT_GT(android.shown, before); });
    android.then(keep);
    android.command(APP_CMD_PAUSE);
    expectNoFrame("paused");
    android.command(APP_CMD_RESUME);
    android.frames(3);
    android.then([&] { EXPECT_GT(android.shown, before); });
    android.loseWindow();
    android.then(keep);
    expectNoFrame("without a window");
    android.run();
    expectClean(android);
}

TEST(Lifecycle, ALostWindowKeepsTheContextAndEverythingInIt) {
    Small android;
    android.startUntilSceneShown(width, height);
    android.then([&] { android.log.clear(); });
    for (int i = 0; i < 3; ++i) {
        android.loseWindow();
        android.window(width, height);
        android.frames(2);
    }
    int before = 0;
    android.then([&] { before = android.shown; });
    android.frames(2);
    android.run();
    EXPECT_GT(android.shown, before);
    EXPECT_EQ(android.contextsMade, 1);
    EXPECT_FALSE(android.logged("renderer:")) << "GL objects were rebuilt";
    expectClean(android);
}

TEST(Lifecycle, RotationGivesASurfaceOfTheNewSize) {
    Small android;
    android.startUntilSceneShown(width, height);
    android.resize(height, width);
    android.then([&] { android.capture = true; });
    android.frames(2);
    android.then([&] {
        EXPECT_EQ(android.screen.width, height);
        EXPECT_EQ(android.screen.height, width);
    });
    android.run();
    EXPECT_EQ(android.contextsMade, 1);
    expectClean(android);
}

// The driver may report the loss at any call of a frame, or while GL objects are set up.
TEST(Lifecycle, AContextLostInTheMiddleOfAFrameIsReplaced) {
    Small android;
    android.startUntilSceneShown(width, height);
    android.then([&] { android.loseContextAtGlError(34); });
    android.frames(20);
    android.run();
    EXPECT_EQ(android.contextsMade, 2);
    expectClean(android);

    Small tested;
    tested.testsDriver = true;
    tested.start(width, height);
    tested.then([&] { tested.loseContextAtGlError(25); });
    tested.frames(20);
    tested.run();
    EXPECT_EQ(tested.contextsMade, 2) << "in the self-test";
    expectClean(tested);
}

TEST(Lifecycle, AContextLostWhilePausedIsReplaced) {
    Small android;
    android.startUntilSceneShown(width, height);
    android.command(APP_CMD_PAUSE);
    android.then([&] { android.contextLost = true; });
    android.loseWindow();
    android.command(APP_CMD_RESUME);
    android.window(width, height);
    int before = 0;
    android.then([&] { before = android.shown; });
    android.frames(3);
    android.run();
    EXPECT_GT(android.shown, before);
    EXPECT_EQ(android.contextsMade, 2);
    expectClean(android);
}

TEST(Lifecycle, LowMemoryInTheBackgroundDropsTheRendererUntilTheAppResumes) {
    Small android;
    android.startUntilSceneShown(width, height);
    int before = 0;
    android.then([&] { before = liveGlObjects("Textures"); });
    android.command(APP_CMD_PAUSE);
    android.command(APP_CMD_LOW_MEMORY);
    android.then([&] { EXPECT_LT(liveGlObjects("Textures"), before); });
    android.command(APP_CMD_RESUME);
    android.frames(60);  // each links a program
    android.then([&] { EXPECT_EQ(liveGlObjects("Textures"), before); });
    android.run();
    expectClean(android);
}

TEST(Lifecycle, SavedStateKeepsACommandFromRunningTwice) {
    TemporaryFolder files;
    for (const bool restored : {false, true}) {
        Small android;
        android.files = files.path();
        android.restored = restored;
        android.intentExtra = "bench scene=none.glb";
        android.startUntilSceneShown(width, height);
        android.command(APP_CMD_SAVE_STATE);
        android.then([&] { EXPECT_NE(android.glue.savedState, nullptr); });
        android.run();
        EXPECT_EQ(android.logged("none.glb"), !restored);
    }
}

TEST(Lifecycle, ASurfaceThatCannotBeMadeWaitsForTheNextWindow) {
    Small android;
    android.failSurface();
    android.start(width, height);
    android.frames(5);
    int before = -1;
    android.then([&] { before = android.shown; });
    android.loseWindow();
    android.window(width, height);
    android.framesUntilLogged(" triangles");
    android.frames(2);
    android.run();
    EXPECT_EQ(before, 0);
    EXPECT_GT(android.shown, 0);
    EXPECT_TRUE(android.logged("the window cannot be drawn into"));
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

TEST(DriverFaultsOfTheApp, ElementsAreBoundAfterTheirVertexArrayAndNothingIsQueried) {
    StandIn android;
    android.intentExtra = "show grid=64 mode=phong pixels=4";
    android.startUntilSceneShown(400, 800);
    struct Spies {
        int finishes = 0;
        ElementBufferCheck elements;
        const GlSpy<&gl::Finish> finished{[this] { ++finishes; }};
        const GlSpy<&gl::BeginQuery> queried{[](GLenum, GLuint) { ADD_FAILURE() << "a query"; }};
    };
    std::unique_ptr<Spies> spies;
    android.then([&] { spies = std::make_unique<Spies>(); });
    android.frames(2);
    android.then([&] {
        EXPECT_GT(spies->elements.uses, 4);
        EXPECT_GT(spies->finishes, 0) << "steps were not timed";
        spies.reset();
    });
    android.run();
    EXPECT_EQ(android.errors(), "");
}

}  // namespace
}  // namespace vct::test
