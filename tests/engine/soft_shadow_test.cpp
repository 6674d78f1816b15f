// The soft shadow out of the shadow map against what a sun with a size leaves behind straight edges: the
// share of its disc, which has a closed form; and that nothing shades itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

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

// Share of a disc of `radius` that a straight edge leaves over, `distance` from its middle to it.
double shareOfDisc(double distance, double radius) {
    const double t = glm::clamp(distance / radius, -1.0, 1.0);
    return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / pi;
}

struct Point {
    glm::dvec3 positionWorld;
    double light;
};

// The shadow on what a camera above the scene sees of it.
std::vector<Point> seenFromAbove(const Scene& scene, const glm::dvec3& directionToLight,
                                 const Settings& settings, double fovDeg) {
    const Context context = openContext(Backend::egl);
    FrameInspector frame(context, scene, lightFrom(directionToLight), settings,
                         lookAt({0, 3, 0.001}, {0, 0, 0}, fovDeg));
    const std::vector<float> light = frame.softShadow();
    std::vector<Point> points;
    for (std::size_t i = 0; i < light.size(); ++i)
        if (frame.pixels()[i].surface) points.push_back({frame.pixels()[i].positionWorld, light[i]});
    return points;
}

// The middle of the floor, away from the ends of the edges.
std::vector<Point> middleOfFloor(const Scene& scene, const glm::dvec3& directionToLight,
                                 const Settings& settings) {
    std::vector<Point> points = seenFromAbove(scene, directionToLight, settings, 36);
    points.erase(std::remove_if(points.begin(), points.end(),
                                [](const Point& point) {
                                    return std::abs(point.positionWorld.x) > 0.8 ||
                                           std::abs(point.positionWorld.z) > 0.3;
                                }),
                 points.end());
    return points;
}

// An edge of a plate over a floor of side 4, which is seen from above along the edge.
struct Edge {
    double height = 1.0;    // of the plate
    double angleDeg = 0.0;  // of its edge against the axes of the shadow map
};

struct Ramp {
    double step = 0.0;      // the largest between neighbouring pixels, over the exact ramp's largest
    double backward = 0.0;  // the largest against the ramp's direction
    double rms = 0.0;       // against the exact share, in the penumbra
    double shift = 0.0;     // mean error there: where the edge is
    double texels = 0.0;    // of the shadow map over the penumbra
};

struct Sun {
    const char* name;
    const char* preset;
    double diameterDeg;
    glm::dvec3 towards;  // leaning over the edge, to +x
    std::vector<double> heights;
    double roughness = 1.0;  // of steps: a low sun's texels of the map are long on the floor
};

// Pixels of the middle of the picture: the plate's only side is its lower one, so that it is not seen.
Ramp rampOf(const Context& context, const Edge& edge, const Sun& disc, int width) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(edge.angleDeg), glm::dvec3(0, 1, 0));
    const auto turned = [&](const glm::dvec3& p) { return glm::dvec3(turn * glm::dvec4(p, 0.0)); };
    Scene scene = emptyScene();
    addQuad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
    addQuad(scene, turned({0, edge.height, -1.2}), turned({1.6, 0, 0}), turned({0, 0, 2.4}));
    scene = finished(std::move(scene));
    const glm::dvec3 directionToLight = glm::normalize(disc.towards);
    const glm::dvec3 inShadow =
        -edge.height / directionToLight.y * glm::dvec3(directionToLight.x, 0, directionToLight.z);

    const int rows = 24;
    Settings settings = presetSettings(disc.preset);
    settings.grid = 64;  // the voxels are not looked at
    settings.size = {width, rows};
    settings.shadowConeAngleDeg = static_cast<float>(disc.diameterDeg);
    const double eyeHeight = 20.0, pixel = 4.0 / width;
    Camera above = lookAt({0, eyeHeight, 0}, {0, 0, -1e-6},
                          glm::degrees(2.0 * std::atan(0.5 * rows * pixel / eyeHeight)));
    above.worldFromCamera = glm::translate(glm::dmat4(1.0), inShadow) * turn * above.worldFromCamera;
    FrameInspector frame(context, scene, lightFrom(directionToLight), settings, above);
    const std::vector<float> light = frame.softShadow();

    const glm::dvec3 onEdge = turned({0, edge.height, 0}), along = turned({0, 0, 1});
    const double radius = std::sin(glm::radians(0.5 * disc.diameterDeg));
    const auto exactAt = [&](std::size_t i) {
        const glm::dvec3 normal = glm::normalize(glm::cross(along, onEdge - frame.pixels()[i].positionWorld));
        return shareOfDisc(glm::dot(normal, directionToLight), radius);
    };
    Ramp ramp;
    double exactStep = 0.0, squares = 0.0, errors = 0.0;
    int inPenumbra = 0;
    for (int row = 0; row < rows; ++row)
        for (int x = 3 * width / 8; x < 5 * width / 8; ++x) {
            const std::size_t i = static_cast<std::size_t>(row) * width + x;
            const double exact = exactAt(i), step = light[i + 1] - light[i], right = exactAt(i + 1) - exact;
            EXPECT_GE(right, -1e-9);  // the shadow is on the left
            exactStep = std::max(exactStep, right);
            ramp.step = std::max(ramp.step, std::abs(step));
            ramp.backward = std::max(ramp.backward, -step);
            if (exact <= 0.0 || exact >= 1.0) continue;
            errors += light[i] - exact;
            squares += std::pow(light[i] - exact, 2.0);
            ++inPenumbra;
        }
    ramp.step /= exactStep;
    ramp.rms = std::sqrt(squares / std::max(inPenumbra, 1));
    ramp.shift = errors / std::max(inPenumbra, 1);
    const double texel = glm::length(scene.boundsWorld.max - scene.boundsWorld.min) / settings.shadowMapSize;
    ramp.texels = 2.0 * radius * edge.height / directionToLight.y / texel;
    return ramp;
}

class Penumbrae : public testing::TestWithParam<Sun> {};
const glm::dvec3 slanted(0.3, 1.0, 0.2);
INSTANTIATE_TEST_SUITE_P(SoftShadow, Penumbrae,
                         testing::Values(Sun{"mobile5", "mobile", 0.5, slanted, {0.1, 0.5, 2.0}},
                                         Sun{"mobile20", "mobile", 2, slanted, {0.1, 0.5, 2.0}},
                                         Sun{"mobile50", "mobile", 5, slanted, {0.1, 0.5, 2.0}},
                                         Sun{"mobile100", "mobile", 10, slanted, {0.1, 0.5, 2.0}},
                                         Sun{"quality20", "quality", 2, slanted, {0.1, 0.5, 2.0}},
                                         Sun{"quality100", "quality", 10, slanted, {0.1, 0.5, 2.0}},
                                         Sun{"overhead", "mobile", 20, {0, 1, 0}, {0.5}},
                                         Sun{"low", "mobile", 5, {0.94, 0.34, 0}, {0.5}, 2.5}),
                         [](const auto& test) { return std::string(test.param.name); });

// Without levels of the map, or with no light between two, steps of the widest are 8 and 5 times the exact
// ones.
TEST_P(Penumbrae, OfAStraightEdgeAreSmoothRampsOfADisc) {
    const Sun& disc = GetParam();
    const Context context = openContext(Backend::egl);
    for (const double height : disc.heights)
        for (const double angleDeg : {0.0, 8.0, 45.0})
            for (const int width : {1280, 1920}) {
                const Ramp ramp = rampOf(context, {height, angleDeg}, disc, width);
                char what[100];
                std::snprintf(what, sizeof what, "%.1f high, %2.0f degrees, %d pixels", height, angleDeg,
                              width);
                EXPECT_LE(ramp.step, 2.1 * disc.roughness) << what;
                EXPECT_LE(ramp.backward, 0.012 * disc.roughness) << what;
                // A narrower one is as wide as the map's filter.
                if (ramp.texels > 8.0) {
                    EXPECT_LE(ramp.rms, std::string(disc.preset) == "mobile" ? 0.08 : 0.05) << what;
                    EXPECT_NEAR(ramp.shift, 0.0, 0.05) << what;
                }
            }
}

// A needle of a sun: nothing is left but the map's own resolution.
TEST(SoftShadow, NeedleSunIsSharpToTheTexel) {
    const glm::dvec3 directionToLight(0, 1, 0);
    const Scene scene = sheetOverFloor(-1, 0);
    const double texel = 2.0 / 512;
    int beside = 0;
    for (const Point& point : middleOfFloor(scene, directionToLight, softMap(0.1F, 512))) {
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
    constexpr float sunDeg = 5.0F;
    const double radius = std::sin(glm::radians(0.5 * sunDeg));
    for (const double width : {0.0625, 0.0156}) {  // 16 and 4 texels
        double errors = 0.0, hidden = 0.0;
        for (const Point& point :
             middleOfFloor(sheetOverFloor(-0.5 * width, 0.5 * width), {0, 1, 0}, softMap(sunDeg, 256))) {
            // The sun overhead is beyond an edge by the sine of the angle to it.
            const auto beyond = [&](double edgeX) {
                const double aside = point.positionWorld.x - edgeX;
                return shareOfDisc(aside / std::hypot(aside, sheetHeight), radius);
            };
            const double blocked = beyond(-0.5 * width) - beyond(0.5 * width);
            ASSERT_NEAR(point.light, 1.0 - blocked, 0.1) << width << " at " << point.positionWorld.x;
            errors += 1.0 - blocked - point.light;
            hidden += blocked;
        }
        EXPECT_GT(hidden, 100.0);
        EXPECT_NEAR(errors / hidden, 0.0, 0.1) << width;
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
    const Image shadow = frame.view(Output::sunVisibility);
    const Image indirect = frame.view(Output::indirectLight);
    const Image all = frame.view(Output::giConeShadow);
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
