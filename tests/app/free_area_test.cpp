// The panel keeps out of system bars, cutouts and rounded corners.
#include "app/free_area.h"

#include <gtest/gtest.h>

#include "app/hud.h"
#include "stand_in/stand_in.h"
#include "support/pictures.h"

namespace vct::test {
namespace {

using app::freeArea;
using app::WindowInsets;

TEST(FreeArea, IsTheWindowWithoutInsets) {
    EXPECT_EQ(freeArea({720, 1280}, {}), glm::ivec4(0, 0, 720, 1280));
}

TEST(FreeArea, LeavesOutBarsAndCutouts) {
    EXPECT_EQ(freeArea({720, 1280}, {{0, 50, 0, 100}, {}}), glm::ivec4(0, 50, 720, 1180));
    EXPECT_EQ(freeArea({1280, 720}, {{80, 0, 96, 0}, {}}), glm::ivec4(80, 0, 1184, 720));
}

// Between a rotation and the next layout the insets are those of the other orientation.
TEST(FreeArea, IgnoresInsetsOfAnotherWindow) {
    EXPECT_EQ(freeArea({100, 600}, {{60, 0, 0, 0}, {}}), glm::ivec4(0, 0, 100, 600));
}

// A pixel is outside if its centre is farther from the corner's circle than the radius.
bool isCutByCorner(glm::ivec2 pixel, glm::ivec2 window, const WindowInsets& insets) {
    const glm::dvec2 at = glm::dvec2(pixel) + 0.5, size(window);
    const auto isOutside = [](int radius, double x, double y) {
        return x < radius && y < radius && std::hypot(radius - x, radius - y) > radius;
    };
    return isOutside(insets.cornerRadii[0], at.x, at.y) ||
           isOutside(insets.cornerRadii[1], size.x - at.x, at.y) ||
           isOutside(insets.cornerRadii[2], size.x - at.x, size.y - at.y) ||
           isOutside(insets.cornerRadii[3], at.x, size.y - at.y);
}

bool isCovered(glm::ivec2 pixel, glm::ivec2 window, const WindowInsets& insets) {
    const app::Edges& edges = insets.edges;
    return pixel.x < edges.left || pixel.y < edges.top || pixel.x >= window.x - edges.right ||
           pixel.y >= window.y - edges.bottom || isCutByCorner(pixel, window, insets);
}

TEST(FreeArea, LeavesOutRoundedCornersAndNoMoreThanNeeded) {
    for (const app::Edges edges : {app::Edges{}, app::Edges{0, 30, 0, 0}, app::Edges{0, 90, 0, 40},
                                   app::Edges{25, 10, 0, 0}, app::Edges{120, 0, 0, 0}}) {
        const glm::ivec2 window(600, 800);
        const WindowInsets insets{edges, {100, 100, 80, 60}};
        const glm::ivec4 free = freeArea(window, insets);
        for (const int x : {free.x, free.z - 1})
            for (const int y : {free.y, free.w - 1})
                EXPECT_FALSE(isCovered({x, y}, window, insets)) << x << ", " << y;
        EXPECT_LE(free.x, std::max(edges.left, 30));
        EXPECT_LE(free.y, std::max(edges.top, 30));
    }
    // Below a status bar that is as high as the radius, the corner costs nothing.
    EXPECT_EQ(freeArea({600, 800}, {{0, 100, 0, 0}, {100, 100, 0, 0}}), glm::ivec4(0, 100, 600, 800));
}

// The insets are those of phones: bars of 24 and 48 dp, gesture bars of 24 dp, cutouts of 32 to 50 dp.
struct Device {
    const char* name;
    glm::ivec2 window;
    int density;
    WindowInsets insets;
};

class PanelOn : public testing::TestWithParam<Device> {};
INSTANTIATE_TEST_SUITE_P(
    Devices, PanelOn,
    testing::Values(
        Device{"SmallPhoneWithThreeButtons", {720, 1280}, 320, {{0, 48, 0, 96}, {}}},
        Device{"PunchHoleAndGesturesUpright", {1080, 2400}, 420, {{0, 128, 0, 63}, {110, 110, 110, 110}}},
        Device{"PunchHoleAndGesturesSideways", {2400, 1080}, 420, {{128, 0, 0, 63}, {110, 110, 110, 110}}},
        Device{"NotchAndThreeButtonsSideways", {1520, 720}, 280, {{84, 0, 89, 0}, {60, 60, 60, 60}}},
        Device{"CornersAloneSideways", {2340, 1080}, 440, {{}, {120, 120, 120, 120}}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_P(PanelOn, CoversNothingOfTheSystem) {
    const auto& [name, window, density, insets] = GetParam();
    const glm::ivec4 free = freeArea(window, insets);
    for (const bool isOpen : {false, true}) {
        app::Hud hud(static_cast<float>(density) / 160.0F);
        app::Choices choices;
        int scene = 0;
        const std::vector<app::FileChoice> scenes(40, {"a.glb", "scenes/a.glb", true});
        app::HudContent content;
        content.choices = &choices;
        content.scene = &scene;
        content.scenes = &scenes;
        content.message = "a message";
        content.possibleGrids = allGrids;
        const auto frames = [&](int count) {
            for (int i = 0; i < count; ++i)
                hud.build(content, window, free, 0.02);
        };
        const auto expectClear = [&](const char* what) {
            int covered = 0, panel = 0;
            for (int y = 0; y < window.y; y += 3)
                for (int x = 0; x < window.x; x += 3)
                    if (hud.covers(glm::vec2(x, y) + 0.5F)) {
                        ++panel;
                        covered += isCovered({x, y}, window, insets);
                    }
            EXPECT_GT(panel, 0);
            EXPECT_EQ(covered, 0) << what;
        };
        frames(3);
        if (isOpen != hud.covers({free.x + 100, free.y + window.y / 3})) {
            hud.toggle();
            frames(3);
        }
        expectClear(isOpen ? "open" : "folded");
        // Opens each list in turn.
        for (int y = free.y + 40; isOpen && y < free.w; y += density / 12) {
            const glm::vec2 row(free.x + 60, y);
            for (const bool down : {true, false, true, false}) {
                hud.touch(row, down);
                frames(2);
                if (!down) expectClear("a list");
            }
        }
    }
}

TEST_P(PanelOn, IsReadableThere) {
    const auto& [name, window, density, insets] = GetParam();
    StandIn android;
    android.density = density;
    android.insets = insets;
    android.intentExtra = "show grid=64 mode=phong pixels=4 preset=mobile";
    android.startUntilSceneShown(window.x, window.y);
    android.then([&] { android.capture = true; });
    android.frames(1);
    android.run();
    EXPECT_EQ(android.errors(), "");
    const glm::ivec4 free = freeArea(window, insets);
    int bright = 0;
    for (int y = free.y; y < free.y + density / 3; ++y)
        for (int x = free.x; x < free.x + density / 2; ++x)
            bright += glm::min(android.screen.at(x, y).r, android.screen.at(x, y).g) > 0.6F;
    EXPECT_GT(bright, 20) << "the button's text";
}

}  // namespace
}  // namespace vct::test
