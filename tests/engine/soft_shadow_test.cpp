// The soft shadow out of the shadow map against what a sun with a size leaves behind straight edges, whose
// share has a closed form; and that nothing shades itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr double sheetHeight = 0.5;  // of the blockers above the floor

Settings softMap(float sunAngleDeg, int pixels = 192) {
    Settings settings = smallSettings(64, pixels);
    settings.shadow = Shadow::softMap;
    settings.shadowMapSize = 512;
    settings.shadowConeAngleDeg = sunAngleDeg;
    return settings;
}

// A floor of side 2 in the plane y = 0 and, half a unit above it, a sheet from x = `from` to x = `to`. The
// sheet's front is below, so that a camera from above looks through it.
Scene sheetOverFloor(double from, double to) {
    Scene scene = emptyScene();
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    addQuad(scene, {from, sheetHeight, -1}, {to - from, 0, 0}, {0, 0, 2});
    return finished(std::move(scene));
}

// Towards the light, `elevationDeg` above the floor, leaning over the edges, which run along z.
glm::dvec3 sunAt(double elevationDeg) {
    return {std::cos(glm::radians(elevationDeg)), std::sin(glm::radians(elevationDeg)), 0.0};
}

// Share of the sun's disc on the side of larger x of the plane through a point of the floor and the edge at
// `edgeX`: a disc cut by a chord, at `t` radii from its centre.
double shareBeyond(double edgeX, const glm::dvec3& position, const glm::dvec3& towardsLight,
                   double sunAngleDeg) {
    const glm::dvec2 toEdge = glm::normalize(glm::dvec2(edgeX - position.x, sheetHeight));
    const double sine = towardsLight.x * toEdge.y - towardsLight.y * toEdge.x;
    const double t = glm::clamp(sine / std::sin(glm::radians(0.5 * sunAngleDeg)), -1.0, 1.0);
    return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / pi;
}

struct Point {
    glm::dvec3 positionWorld;
    double light;
};

// The shadow on what a camera above the scene sees of it.
std::vector<Point> seenFromAbove(const Scene& scene, const glm::dvec3& towardsLight, const Settings& settings,
                                 double fovDeg) {
    const Context context = openContext(Backend::egl);
    FrameInspector frame(context, scene, lightFrom(towardsLight), settings,
                         lookAt({0, 3, 0.001}, {0, 0, 0}, fovDeg));
    const std::vector<float> light = frame.softShadow();
    std::vector<Point> points;
    for (std::size_t i = 0; i < light.size(); ++i)
        if (frame.pixels()[i].surface) points.push_back({frame.pixels()[i].positionWorld, light[i]});
    return points;
}

// The middle of the floor, away from the ends of the edges.
std::vector<Point> middleOfFloor(const Scene& scene, const glm::dvec3& towardsLight,
                                 const Settings& settings) {
    std::vector<Point> points = seenFromAbove(scene, towardsLight, settings, 36);
    points.erase(std::remove_if(points.begin(), points.end(),
                                [](const Point& point) {
                                    return std::abs(point.positionWorld.x) > 0.8 ||
                                           std::abs(point.positionWorld.z) > 0.3;
                                }),
                 points.end());
    return points;
}

struct Fit {
    double rmse = 0.0;     // in the penumbra
    double largest = 0.0;  // anywhere
    double width = 0.0;    // of the penumbra, over the right one's
    double shift = 0.0;    // of all light on the floor, over the penumbra's width: where the edge is
    int inside = 0;        // points in the penumbra
};

Fit fit(const std::vector<Point>& points, const std::function<double(const glm::dvec3&)>& share) {
    Fit fit;
    double squares = 0.0, found = 0.0, right = 0.0, lightError = 0.0;
    for (const Point& point : points) {
        const double truth = share(point.positionWorld);
        const double error = point.light - truth;
        fit.largest = std::max(fit.largest, std::abs(error));
        // Where both answers are 0 or 1 neither sum grows: each is the width of its penumbra.
        found += point.light * (1.0 - point.light);
        right += truth * (1.0 - truth);
        lightError += error;
        if (truth <= 0.01 || truth >= 0.99) continue;
        squares += error * error;
        ++fit.inside;
    }
    fit.rmse = std::sqrt(squares / std::max(fit.inside, 1));
    fit.width = found / right;
    fit.shift = lightError / std::max(fit.inside, 1);
    return fit;
}

void print(const char* name, const Fit& fit) {
    std::printf("  %-24s penumbra %5d points, RMSE %.3f, largest error %.3f, width x %.2f, shift %+.3f\n",
                name, fit.inside, fit.rmse, fit.largest, fit.width, fit.shift);
}

struct Penumbra {
    const char* name;
    float sunAngleDeg;
    double elevationDeg;
    int filterTaps;
    double rmse, largest;
};

class HalfPlane : public testing::TestWithParam<Penumbra> {};
INSTANTIATE_TEST_SUITE_P(SoftShadow, HalfPlane,
                         testing::Values(Penumbra{"Overhead", 5, 90, 16, 0.05, 0.15},
                                         Penumbra{"FewTaps", 5, 90, 8, 0.07, 0.2},
                                         Penumbra{"Slanted", 5, 50, 16, 0.05, 0.15},
                                         Penumbra{"Grazing", 5, 20, 16, 0.05, 0.15},
                                         Penumbra{"WideSun", 20, 90, 16, 0.05, 0.15},
                                         Penumbra{"WideSunSlanted", 20, 50, 16, 0.05, 0.15}),
                         [](const auto& test) { return test.param.name; });

// The edge's shadow falls on the middle of the floor.
TEST_P(HalfPlane, PenumbraIsThatOfADisc) {
    const Penumbra& c = GetParam();
    const glm::dvec3 towardsLight = sunAt(c.elevationDeg);
    const double edgeX = sheetHeight * towardsLight.x / towardsLight.y;
    Settings settings = softMap(c.sunAngleDeg);
    settings.filterTaps = c.filterTaps;
    const auto points =
        middleOfFloor(sheetOverFloor(std::min(edgeX, 0.0) - 1.0, edgeX), towardsLight, settings);
    ASSERT_GT(points.size(), 5000U);
    const Fit found =
        fit(points, [&](const glm::dvec3& p) { return shareBeyond(edgeX, p, towardsLight, c.sunAngleDeg); });
    print(c.name, found);
    EXPECT_GT(found.inside, 100);
    EXPECT_LT(found.rmse, c.rmse);
    EXPECT_LT(found.largest, c.largest);
    EXPECT_NEAR(found.width, 1.0, 0.15);
    EXPECT_NEAR(found.shift, 0.0, 0.03);
}

// A needle of a sun: nothing is left but the map's own resolution.
TEST(SoftShadow, NeedleSunIsSharpToTheTexel) {
    const glm::dvec3 towardsLight(0, 1, 0);
    const Scene scene = sheetOverFloor(-1, 0);
    const double texel = 2.0 / 512;
    int beside = 0;
    for (const Point& point : middleOfFloor(scene, towardsLight, softMap(0.1F, 512))) {
        const double x = point.positionWorld.x;
        if (std::abs(x) < 3.0 * texel) {
            ++beside;
            continue;
        }
        ASSERT_EQ(point.light, x < 0.0 ? 0.0 : 1.0) << "at x = " << x / texel << " texels from the edge";
    }
    EXPECT_GT(beside, 100);
}

// Strips narrower than the search, and narrower than their own penumbra: none of the sun is wholly hidden.
TEST(SoftShadow, StripsAreNotLost) {
    const glm::dvec3 towardsLight(0, 1, 0);
    const struct {
        const char* name;
        double width, largest;
    } strips[] = {{"strip of 16 texels", 0.0625, 0.1}, {"strip of 4 texels", 0.0156, 0.1}};
    for (const auto& strip : strips) {
        const auto points = middleOfFloor(sheetOverFloor(-0.5 * strip.width, 0.5 * strip.width), towardsLight,
                                          softMap(5, 256));
        const Fit found = fit(points, [&](const glm::dvec3& p) {
            return 1.0 - shareBeyond(-0.5 * strip.width, p, towardsLight, 5) +
                   shareBeyond(0.5 * strip.width, p, towardsLight, 5);
        });
        print(strip.name, found);
        EXPECT_LT(found.largest, strip.largest) << strip.name;
        EXPECT_NEAR(found.shift, 0.0, 0.03) << strip.name;
    }
}

// Up to the map's border, at every size of the sun, with the light as flat as 3 degrees.
TEST(SoftShadow, NothingShadesItself) {
    for (const float sunAngleDeg : {0.1F, 5.0F, 20.0F, 170.0F})
        for (const double elevationDeg : {90.0, 45.0, 10.0, 3.0})
            for (const double turnDeg : {0.0, 30.0}) {
                const Scene scene = lonePlane(turnDeg);
                const glm::dmat3 turn(scene.instances.front().worldFromObject);
                const auto points =
                    seenFromAbove(scene, turn * sunAt(elevationDeg), softMap(sunAngleDeg, 128), 45);
                EXPECT_GT(points.size(), 5000U);
                const auto dark = std::count_if(points.begin(), points.end(),
                                                [](const Point& point) { return point.light < 1.0; });
                EXPECT_EQ(dark, 0) << "sun of " << sunAngleDeg << " degrees at " << elevationDeg
                                   << " degrees above the plane, turned by " << turnDeg;
            }
}

TEST(SoftShadow, AwayFromTheSunThereIsNone) {
    const auto points = seenFromAbove(lonePlane(0), {0.1, -1, 0}, softMap(5), 45);
    ASSERT_GT(points.size(), 5000U);
    for (const Point& point : points)
        ASSERT_EQ(point.light, 0.0);
}

// Eq. 4.9 leaves a tenth of the sun in every shadow of the thesis's cone; here the shadow is black.
TEST(SoftShadow, IsAllThatDimsTheSunInMode5) {
    const Context context = openContext(Backend::egl);
    const Scene scene = sheetOverFloor(-1, 0);
    const Settings settings = softMap(5, 96);
    const DirectionalLight light = lightFrom({0, 1, 0});
    FrameInspector frame(context, scene, light, settings, lookAt({0, 3, 0.001}, {0, 0, 0}, 36));
    const Image shadow = frame.view(VCT_VIEW_CONE_SHADOW);
    const Image indirect = frame.view(VCT_VIEW_INDIRECT);
    const Image all = frame.view(VCT_MODE_GI_CONE_SHADOW);
    const std::vector<SurfacePixel>& pixels = frame.pixels();
    int dark = 0, bright = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].surface) continue;
        const double direct = pixels[i].albedo.x * pixels[i].normal.y * shadow.pixels[i].x;
        ASSERT_NEAR(all.pixels[i].x, direct + indirect.pixels[i].x, 2e-3);
        dark += shadow.pixels[i].x == 0.0F;
        bright += shadow.pixels[i].x == 1.0F;
    }
    EXPECT_GT(dark, 1000);
    EXPECT_GT(bright, 1000);
}

}  // namespace
}  // namespace vct::test
