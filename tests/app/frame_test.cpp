// The app shows the pictures of `vct render`.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "cli/program_run.h"
#include "image/image.h"
#include "stand_in/stand_in.h"
#include "support/errors.h"
#include "support/lesser_driver.h"
#include "support/moving_scenes.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

// The window without the panel. `scenes`: the APK's folder, or "" for the source tree's.
Image screenOf(const std::string& show, int width, int height, const std::string& scenes = "") {
    StandIn android;
    if (!scenes.empty()) android.scenes = scenes;
    android.intentExtra = "show display=off " + show;
    android.startUntilSceneShown(width, height);
    android.then([&] { android.capture = true; });
    android.frames(1);
    android.run();
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
    return android.screen;
}

// The largest difference of 8-bit values between the window and the picture in a file. At edges, which the
// window smooths, it is the difference to the nearest value in the 9 x 9 pixels around.
long maxDifference(const Image& screen, const std::string& file) {
    const Image picture = readImage(file);
    if (screen.pixels.size() != picture.pixels.size()) return 256;
    const auto shown = [&](int x, int y, int c) {
        return std::lround(srgbEncode(picture.at(std::clamp(x, 0, picture.width - 1),
                                                 std::clamp(y, 0, picture.height - 1))[c]) *
                           255.0F);
    };
    long largest = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto rangeWithin = [&](int radius, int c) {
                std::pair range(255L, 0L);
                for (int dy = -radius; dy <= radius; ++dy)
                    for (int dx = -radius; dx <= radius; ++dx)
                        range = {std::min(range.first, shown(x + dx, y + dy, c)),
                                 std::max(range.second, shown(x + dx, y + dy, c))};
                return range;
            };
            bool edge = false;
            for (int c = 0; c < 3; ++c)
                edge |= rangeWithin(1, c).second - rangeWithin(1, c).first > 8;
            for (int c = 0; c < 3; ++c) {
                const auto [low, high] = rangeWithin(edge ? 4 : 0, c);
                const long value = std::lround(screen.at(x, y)[c] * 255.0F);
                largest = std::max({largest, low - value, value - high});
            }
        }
    return largest;
}

TEST(Frame, EqualsThePictureOfRender) {
    const Image screen =
        screenOf("scene=courtyard.glb preset=thesis pixels=1 grid=64 mode=gi-cone-shadow", 120, 90);
    ProgramRun program;
    program.expectSuccess(
        "render " VCT_SOURCE_DIR
        "/assets/courtyard.glb --preset thesis --grid 64 --size 120x90 --samples 1 --out out");
    const std::string file = program.folder.file("out/gi-cone-shadow.png");
    EXPECT_EQ(maxDifference(screen, file), 0);
    const Image picture = readImage(file);
    int smoothed = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        smoothed += std::abs(srgbEncode(picture.pixels[i].g) - screen.pixels[i].g) > 0.05F ? 1 : 0;
    EXPECT_GT(smoothed, 300) << "edges are not smooth";
}

// The filter of the scaled frame reads the smoothed one, so that tone mapping and smoothing cost no more in a
// window of many pixels.
TEST(Frame, IsSmoothedBeforeItIsScaledToTheWindow) {
    const std::string show = "scene=courtyard.glb preset=thesis grid=64 mode=phong pixels=";
    const Image small = screenOf(show + "1", 60, 46), screen = screenOf(show + "2", 120, 92);
    float largest = 0.0F;
    for (int y = 0; y < screen.height; ++y)
        for (int x = 0; x < screen.width; ++x) {
            // The centre of each pixel is a quarter of a pixel from that of the nearest one of the frame.
            const int x0 = x / 2, y0 = y / 2;
            const int x1 = std::clamp(x0 + (x % 2 == 1 ? 1 : -1), 0, small.width - 1);
            const int y1 = std::clamp(y0 + (y % 2 == 1 ? 1 : -1), 0, small.height - 1);
            const glm::vec3 expected = 0.75F * (0.75F * small.at(x0, y0) + 0.25F * small.at(x1, y0)) +
                                       0.25F * (0.75F * small.at(x0, y1) + 0.25F * small.at(x1, y1));
            const glm::vec3 difference = glm::abs(screen.at(x, y) - expected);
            largest = std::max({largest, difference.x, difference.y, difference.z});
        }
    EXPECT_LE(largest, 1.5F / 255.0F);
}

TEST(Animated, APoseIsThePictureOfRenderAtThatTime) {
    // Light of the other presets converges over several frames.
    const Image screen = screenOf("scene=moving.glb preset=thesis pixels=1 mode=gi time=1.5", 96, 72);
    ProgramRun program;
    program.expectSuccess("render " VCT_SOURCE_DIR
                          "/assets/moving.glb --preset thesis --size 96x72 --samples 1 --out out "
                          "--mode gi --time 1.5");
    EXPECT_LE(maxDifference(screen, program.folder.file("out/gi.png")), 1);
}

TEST(Animated, PlaysUnlessItIsStopped) {
    const auto changes = [](const std::string& how) {
        StandIn android;
        android.intentExtra = "show display=off scene=moving.glb preset=mobile pixels=1 mode=phong " + how;
        android.startUntilSceneShown(96, 72);
        android.then([&] { android.capture = true; });
        android.frames(1);
        Image first;
        android.then([&] { first = android.screen; });
        android.then([] { std::this_thread::sleep_for(std::chrono::milliseconds(300)); });
        android.frames(1);
        android.run();
        EXPECT_EQ(android.errors(), "");
        return first.pixels != android.screen.pixels;
    };
    EXPECT_TRUE(changes(""));
    EXPECT_FALSE(changes("time=1"));
}

// A floor and a box below a row of lights.
Bytes sceneWithLights(const std::vector<double>& candela) {
    GltfBuilder builder = openFloor();
    addCube(builder, {0.8F, 0.3F, 0.1F}, {{"translation", {0, 0.5, 0}}});
    json& lights = builder.document["extensions"]["KHR_lights_punctual"]["lights"];
    for (std::size_t i = 0; i < candela.size(); ++i) {
        lights.push_back({{"type", "point"}, {"intensity", candela[i]}});
        builder.node({{"translation", {2.0 * static_cast<double>(i) - 1.0, 2, 0.5}},
                      {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
    }
    return builder.glb();
}

// The mode phong has no shadow maps and voxels, which differ between the two scenes.
TEST(Lights, GiveNoLightIfTheyAreOff) {
    const TemporaryFolder scenes;
    writeBytes(scenes.file("both.glb"), sceneWithLights({40, 30}));
    writeBytes(scenes.file("first.glb"), sceneWithLights({40}));
    const auto screenWith = [&](const std::string& scene) {
        return screenOf("preset=mobile pixels=1 mode=phong scene=" + scene, 96, 72, scenes.path());
    };
    const Image first = screenWith("first.glb");
    EXPECT_TRUE(screenWith("both.glb lights-off=2").pixels == first.pixels);
    EXPECT_FALSE(screenWith("both.glb").pixels == first.pixels);
    EXPECT_FALSE(screenWith("both.glb lights-off=1").pixels == first.pixels);
}

TEST(Sky, OfASceneWithoutLightIsThatOfRender) {
    const TemporaryFolder scenes;
    GltfBuilder builder;
    builder.triangle();
    builder.node({{"camera", builder.add("cameras", {{"type", "perspective"},
                                                     {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}})},
                  {"translation", {0.5, 0.5, 2}}});
    writeBytes(scenes.file("unlit.glb"), builder.glb());
    const auto screenWith = [&](const std::string& sky) {
        return screenOf("scene=unlit.glb preset=thesis grid=64 pixels=1 mode=gi" + sky, 96, 72,
                        scenes.path());
    };
    const Image screen = screenWith("");
    ProgramRun program;
    program.expectSuccess("render " + scenes.file("unlit.glb") +
                          " --preset thesis --grid 64 --size 96x72 --samples 1 --out out --mode gi");
    EXPECT_LE(maxDifference(screen, program.folder.file("out/gi.png")), 1);
    EXPECT_GT(screen.at(2, 2).b, 0.1F);
    EXPECT_EQ(screenWith(" sky=dark").at(2, 2), glm::vec3(0.0F));
}

// Compares 8-bit values. Bricks in other places may change the last bit (support/pictures.h).
long largestDifference(const Image& a, const Image& b) {
    float largest = 0.0F;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(a.pixels[i][c] - b.pixels.at(i)[c]));
    return std::lround(largest * 255.0F);
}

// A floor of 24 m with a box, which one cube has in voxels of 38 cm and two cascades in 19 cm.
TEST(Frame, ALargeSceneHasCascadesUnlessTheirNumberIsGiven) {
    const TemporaryFolder scenes;
    GltfBuilder builder = openFloor();
    builder.document["nodes"][0]["scale"] = {6, 1, 6};
    addCube(builder, {0.8F, 0.3F, 0.1F}, {{"translation", {0, 0.6, 0}}, {"scale", {1.2, 1.2, 1.2}}});
    writeBytes(scenes.file("large.glb"), builder.glb());
    const auto screenWith = [&](const std::string& cascades) {
        return screenOf("preset=mobile grid=64 pixels=1 mode=ao scene=large.glb" + cascades, 96, 72,
                        scenes.path());
    };
    const Image screen = screenWith("");
    EXPECT_LE(largestDifference(screen, screenWith(" cascades=2")), 1);
    EXPECT_GT(largestDifference(screen, screenWith(" cascades=1")), 1);
}

TEST(Frame, TheThesissSquareIsNotStretched) {
    const Image screen = screenOf("grid=64 mode=phong pixels=thesis", 128, 64);
    EXPECT_EQ(screen.at(10, 32), glm::vec3(0.0F));
    EXPECT_EQ(screen.at(117, 32), glm::vec3(0.0F));
    EXPECT_GT(glm::length(screen.at(64, 32)), 0.05F);
}

// Letters are bright.
void expectText(const Image& screen, int left, int top, int right, int bottom) {
    int bright = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            bright += glm::min(screen.at(x, y).r, screen.at(x, y).g) > 0.6F;
    const int area = (right - left) * (bottom - top);
    EXPECT_GT(bright, area / 200);
    EXPECT_LT(bright, area / 2);
}

TEST(Display, IsReadableOnAPhone) {
    StandIn android;
    android.density = 440;
    android.intentExtra = "show grid=64 mode=gi pixels=4 scene=moving.glb";
    android.startUntilSceneShown(1080, 2340);
    // The panel is folded until its button is touched.
    for (const int action : {AMOTION_EVENT_ACTION_DOWN, AMOTION_EVENT_ACTION_UP}) {
        android.touch(action, {{0, 60.0F, 60.0F}});
        android.frames(2);
    }
    android.then([&] { android.capture = true; });
    android.frames(2);
    android.run();
    EXPECT_EQ(android.errors(), "");
    expectText(android.screen, 0, 0, 1000, 1080);
}

TEST(Display, SaysWhichExtensionIsMissing) {
    for (const char* version : {"3.1", "3.0"}) {
        const LesserDriver driver(version, "-GL_OES_shader_image_atomic");
        StandIn android;
        android.density = 440;
        android.start(1080, 2340);
        android.frames(3);
        android.then([&] { android.capture = true; });
        android.frames(1);
        android.run();
        EXPECT_EQ(android.misuse, std::vector<std::string>{});
        expectMentions(android.errors(), {"GL_OES_shader_image_atomic"});
        EXPECT_GE(android.shown, 4);
        expectText(android.screen, 0, 0, 1080, 500);
    }
}

}  // namespace
}  // namespace vct::test
