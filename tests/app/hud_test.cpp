// Touches on the panel.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/hud.h"
#include "stand_in/stand_in.h"
#include "support/errors.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

constexpr glm::ivec2 window{400, 800};

// A panel without GL, which is open.
class Fingers {
  public:
    Fingers() {
        frames(1);
        hud.toggle();  // the window is so narrow that it starts folded
    }
    app::HudActions tap(glm::vec2 at) {
        hud.touch(at, true);
        hud.touch(at, false);
        return frames();
    }
    app::HudActions drag(glm::vec2 from, glm::vec2 to) {
        hud.touch(from, true);
        frames(1);
        hud.touch(to, true);
        frames(2);
        hud.touch(to, false);
        return frames();
    }
    // The actions of all of these frames.
    app::HudActions frames(int count = 4) {
        app::HudActions all;
        for (int i = 0; i < count; ++i) {
            app::HudContent content;
            content.choices = &choices;
            content.scene = &scene;
            content.scenes = &scenes;
            content.message = message;
            content.possibleGrids = [&] { return grids; };
            content.animated = animated;
            content.lights = lights;
            content.skies = &skies;
            content.cameras = cameras;
            content.opensFiles = true;
            const app::HudActions actions = hud.build(content, size, {0, 0, size}, 0.02);
            all.resetView |= actions.resetView;
            all.rescan |= actions.rescan;
            all.measure |= actions.measure;
            all.dismiss |= actions.dismiss;
            all.openFile |= actions.openFile;
            if (actions.camera) all.camera = actions.camera;
        }
        return all;
    }

    glm::ivec2 size = window;
    app::Hud hud{1.0F};
    app::Choices choices;
    std::vector<app::FileChoice> scenes{{"a.glb", "scenes/a.glb", true}, {"b.glb", "/files/b.glb", false}};
    int scene = 0;
    std::string message;
    std::vector<int> grids = allGrids();
    bool animated = false;
    std::vector<std::string> lights, cameras;
    std::vector<app::FileChoice> skies;
};

constexpr glm::vec2 corner{25.0F, 20.0F};  // the button that hides and shows

TEST(Hud, HidesAndShows) {
    Fingers fingers;
    fingers.frames();
    const glm::vec2 inside(100.0F, 200.0F);
    EXPECT_TRUE(fingers.hud.covers(inside));
    EXPECT_FALSE(fingers.hud.covers({390.0F, 790.0F}));
    fingers.tap(corner);
    EXPECT_FALSE(fingers.hud.covers(inside)) << "a touch there turns the view again";
    EXPECT_TRUE(fingers.hud.covers(corner));
    fingers.tap(corner);
    EXPECT_TRUE(fingers.hud.covers(inside));
}

// At 320 dpi the panel has 674 pixels.
TEST(Hud, StartsFoldedWhereItWouldCoverMoreThanAQuarterOfTheWidth) {
    for (const glm::ivec2 size :
         {glm::ivec2(720, 1280), glm::ivec2(1280, 720), glm::ivec2(2680, 700), glm::ivec2(2720, 700)}) {
        Fingers fingers;
        app::Hud hud(2.0F);
        app::HudContent content;
        content.choices = &fingers.choices;
        content.scene = &fingers.scene;
        content.scenes = &fingers.scenes;
        const auto build = [&] { hud.build(content, size, {0, 0, size}, 0.02); };
        for (int i = 0; i < 3; ++i)
            build();
        const glm::vec2 button(30.0F, 30.0F), below(100.0F, 400.0F);
        const bool isFolded = size.x < 4 * 674;
        EXPECT_TRUE(hud.covers(button));
        EXPECT_EQ(hud.covers(below), !isFolded) << size.x;
        hud.touch(button, true);
        hud.touch(button, false);
        for (int i = 0; i < 4; ++i)
            build();
        EXPECT_EQ(hud.covers(below), isFolded) << size.x;
    }
}

TEST(Hud, FoldedItStillShowsWhatTheUserMustRead) {
    Fingers fingers;
    fingers.frames();
    fingers.tap(corner);
    const glm::vec2 beside(300.0F, 20.0F);
    ASSERT_FALSE(fingers.hud.covers(beside));
    fingers.message = "the scene cannot be loaded";
    fingers.frames();
    EXPECT_TRUE(fingers.hud.covers(beside));
    EXPECT_FALSE(fingers.hud.covers({100.0F, 200.0F}));
    bool isDismissed = false;
    for (float y = 45.0F; y < 120.0F; y += 8.0F)
        isDismissed |= fingers.tap({40.0F, y}).dismiss;
    EXPECT_TRUE(isDismissed);
}

// Every row of the panel is touched, and every list that opens.
TEST(Hud, EveryChoiceCanBeChangedByTouch) {
    Fingers fingers;
    fingers.message = "wrong";
    fingers.animated = true;
    fingers.lights = {"light", "light", ""};
    fingers.cameras = {"camera", "camera"};
    fingers.skies = {{"a.hdr", "/files/a.hdr"}};
    fingers.frames();
    const app::Choices before = fingers.choices;
    app::HudActions actions;
    std::set<std::string> changed;
    const auto look = [&] {
        const app::Choices& now = fingers.choices;
        const auto note = [&](bool hasChanged, const char* choice) {
            if (hasChanged) changed.insert(choice);
        };
        note(now.mode != before.mode, "mode");
        note(now.grid != before.grid, "grid");
        note(now.preset != before.preset || presetNames().size() == 1, "preset");
        note(now.resolution != before.resolution, "pixels");
        note(now.coneAngleDeg != before.coneAngleDeg, "cone");
        note(now.lightAnglesDeg.has_value(), "light");
        note(now.lightsOff.any(), "lights");
        note(now.lightsOff.test(1), "second light");
        note(now.sky != before.sky, "sky");
        note(now.sky == app::Sky::picture && now.skyPicture == "/files/a.hdr", "picture of a sky");
        note(now.timeSteps != before.timeSteps, "time");
        note(now.play != before.play, "play");
        note(fingers.scene != 0, "scene");
    };
    for (float y = 45.0F; y < 700.0F; y += 8.0F) {
        for (const float below : {22.0F, 40.0F, 60.0F, 80.0F, 100.0F}) {
            const app::HudActions first = fingers.tap({60.0F, y});
            const app::HudActions second = fingers.tap({60.0F, y + below});
            actions.rescan |= first.rescan || second.rescan;
            actions.resetView |= first.resetView || second.resetView;
            actions.dismiss |= first.dismiss || second.dismiss;
            actions.openFile |= first.openFile || second.openFile;
            if (second.camera) actions.camera = second.camera;
            look();
        }
        fingers.drag({60.0F, y}, {180.0F, y});
        look();
        actions.measure |= fingers.tap({210.0F, y}).measure;
        fingers.tap({165.0F, y});  // the second one of a row
        look();
    }
    EXPECT_EQ(changed,
              (std::set<std::string>{"cone", "grid", "lights", "light", "mode", "pixels", "play",
                                     "picture of a sky", "preset", "scene", "second light", "sky", "time"}));
    EXPECT_EQ(actions.camera, 1);
    EXPECT_TRUE(actions.openFile);
    EXPECT_TRUE(actions.rescan) << "opening the list of scenes looks for new ones";
    EXPECT_TRUE(actions.resetView);
    EXPECT_TRUE(actions.dismiss);
    EXPECT_TRUE(actions.measure);
}

// A window that is too low for the panel. A finger may begin to scroll on any widget, which it does not
// change.
TEST(Hud, AFingerScrollsThePanel) {
    Fingers fingers;
    fingers.size = {400, 300};
    fingers.frames();
    const app::Choices before = fingers.choices;
    const auto findsMeasure = [&] {
        bool found = false;
        for (float y = 200.0F; y < 300.0F; y += 8.0F)
            found |= fingers.tap({210.0F, y}).measure;
        return found;
    };
    for (float x = 10.0F; x < 300.0F; x += 10.0F) {
        fingers.drag({x, 280.0F}, {x + 5.0F, 40.0F});
        fingers.drag({x, 40.0F}, {x + 5.0F, 280.0F});
    }
    EXPECT_EQ(fingers.choices, before);
    EXPECT_FALSE(findsMeasure());
    fingers.tap({390.0F, 290.0F});  // closes the list that a tap has opened
    fingers.choices = before;
    for (int i = 0; i < 3; ++i)
        fingers.drag({100.0F, 280.0F}, {100.0F, 40.0F});
    EXPECT_EQ(fingers.choices, before);
    EXPECT_TRUE(findsMeasure());
}

TEST(Hud, AFingerScrollsAList) {
    Fingers fingers;
    fingers.size = {400, 500};
    fingers.lights = std::vector<std::string>(40, "light");
    fingers.frames();
    const auto highestWith = [&](int drags) {
        fingers.choices.lightsOff.reset();
        for (float y = 250.0F; y < 500.0F && fingers.choices.lightsOff.none(); y += 12.0F) {
            fingers.tap({60.0F, y});  // opens a list, if there is one
            for (int i = 0; i < drags; ++i)
                fingers.drag({60.0F, 400.0F}, {60.0F, 100.0F});
            fingers.tap({60.0F, 300.0F});
            fingers.tap({60.0F, y});
        }
        std::size_t highest = 0;
        for (std::size_t i = 0; i < fingers.lights.size(); ++i)
            if (fingers.choices.lightsOff.test(i)) highest = i;
        return highest;
    };
    const std::size_t first = highestWith(0), last = highestWith(5);
    EXPECT_GT(first, 0U);
    EXPECT_GT(last, first + 10);
}

// The system takes the finger away, for a gesture of its own.
TEST(Hud, ACancelledTouchPressesNothing) {
    for (const bool moved : {false, true}) {
        Fingers fingers;
        fingers.frames();
        fingers.hud.touch(corner, true);
        if (moved) fingers.hud.touch(corner + glm::vec2(15.0F, 0.0F), true);
        fingers.frames();
        fingers.hud.cancelTouch();
        fingers.hud.touch(corner, false);
        fingers.frames();
        EXPECT_TRUE(fingers.hud.covers({100.0F, 200.0F})) << "the panel is hidden";
    }
}

TEST(Hud, OffersNoGridThatIsNotPossible) {
    const auto chosenWith = [](const std::vector<int>& grids) {
        Fingers fingers;
        fingers.grids = grids;
        fingers.frames();
        std::set<int> chosen;
        for (float y = 45.0F; y < 400.0F; y += 8.0F)
            for (const float below : {22.0F, 40.0F, 60.0F, 80.0F, 100.0F}) {
                fingers.choices.grid = 256;
                fingers.choices.preset = "thesis";
                fingers.tap({60.0F, y});
                fingers.tap({60.0F, y + below});
                if (fingers.choices.preset == "thesis") chosen.insert(fingers.choices.grid);
            }
        return chosen;
    };
    EXPECT_EQ(chosenWith(allGrids()), (std::set<int>{64, 128, 256, 512}));
    EXPECT_EQ(chosenWith({64, 128}), (std::set<int>{64, 128, 256})) << "256 is where it began";
}

// The driver fails to compile any shader after the first picture.
TEST(Hud, AChangeThatFailsSaysSoAndKeepsThePicture) {
    StandIn android;
    android.intentExtra = "show grid=64 mode=ao pixels=4";
    android.startUntilSceneShown(window.x, window.y);
    for (const int action : {AMOTION_EVENT_ACTION_DOWN, AMOTION_EVENT_ACTION_UP}) {
        android.touch(action, {{0, corner.x, corner.y}});
        android.frames(2);
    }
    android.command(APP_CMD_LOW_MEMORY);  // drops the programs of other modes and presets
    android.then([&] {
        EXPECT_EQ(android.errors(), "");
        android.shadersFrom = "void main() {";
        android.shadersTo = "void main() { nonsense;";
    });
    for (float y = 180.0F; y < 420.0F; y += 12.0F)
        for (const float at : {y, y + 50.0F}) {
            android.touch(AMOTION_EVENT_ACTION_DOWN, {{0, 60.0F, at}});
            android.touch(AMOTION_EVENT_ACTION_UP, {{0, 60.0F, at}});
            android.frames(3);
        }
    android.then([&] {
        android.shadersFrom.clear();
        android.capture = true;
    });
    android.frames(4);
    android.run();
    expectMentions(android.errors(), {"does not compile"});
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
    EXPECT_GT(glm::length(android.screen.at(window.x / 2, window.y * 11 / 16)), 0.1F)
        << "the picture is gone";
}

// The pixels of the screen in the colour of messages, once the scene is shown.
int messagePixels(const std::string& intentExtra) {
    StandIn android;
    android.intentExtra = intentExtra;
    android.startUntilSceneShown(window.x, window.y);
    android.then([&] { android.capture = true; });
    android.frames(3);
    android.run();
    const glm::vec3 color(1.0F, 0.75F, 0.3F);
    return static_cast<int>(
        std::count_if(android.screen.pixels.begin(), android.screen.pixels.end(),
                      [&](const glm::vec3& pixel) { return glm::length(pixel - color) < 0.05F; }));
}

TEST(Hud, TheMessageOfAWrongCommandStaysWhenTheSceneHasLoaded) {
    const std::string small = "show grid=64 mode=ao pixels=4";
    EXPECT_LT(messagePixels(small), 20);
    EXPECT_GT(messagePixels("show mode=none"), 100);
    EXPECT_GT(messagePixels(small + " scene=none.glb"), 100);
}

TEST(Hud, ASceneThatCannotBeLoadedIsReported) {
    TemporaryFolder files;
    writeBytes(files.file("broken.glb"), "glTF, or not");
    StandIn android;
    android.files = files.path();
    android.intentExtra = "show grid=64 mode=ao scene=broken.glb";
    android.start(96, 64);
    android.framesUntilLogged("broken.glb:");
    android.frames(3);
    android.run();
    expectMentions(android.errors(), {"broken.glb"});
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

}  // namespace
}  // namespace vct::test
