// The soft shadow from the shadow map behind straight edges, where the visible share of the sun's disc has a
// closed form. No surface shades itself.
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
    settings.voxels = Voxels::directional;
    settings.shadowMapSize = 512;
    settings.shadowConeAngleDeg = sunAngleDeg;
    return settings;
}

// A floor of side 2 in the plane y = 0 and, half a unit above it, a sheet from x = `from` to x = `to`. The
// front of the sheet is below, so a camera above sees through it.
Scene sheetOverFloor(double from, double to) {
    Scene scene = emptyScene();
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    addQuad(scene, {from, sheetHeight, -1}, {to - from, 0, 0}, {0, 0, 2});
    return finished(std::move(scene));
}

// A direction towards the light, `elevationDeg` above the floor and across the edges, which run along z.
glm::dvec3 sunAt(double elevationDeg) {
    return {std::cos(glm::radians(elevationDeg)), std::sin(glm::radians(elevationDeg)), 0.0};
}

// Share of a disc of `radius` beyond a straight edge at `distance` from its middle.
double shareOfDisc(double distance, double radius) {
    const double t = glm::clamp(distance / radius, -1.0, 1.0);
    return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / pi;
}

struct Point {
    glm::dvec3 positionWorld;
    double light;
};

// The shadow on the surfaces that a camera above the scene sees.
std::vector<Point> seenFromAbove(const Scene& scene, const glm::dvec3& directionToLight,
                                 const Settings& settings, double fovDeg) {
    const Context context = openContext(Backend::egl);
    FrameInspector frame(context, scene, lightFrom(directionToLight), settings,
                         lookAt({0, 3, 0.001}, {0, 0, 0}, fovDeg));
    std::vector<Point> points;
    for (const SeenSurface& pixel : frame.seen(Output::sunVisibility))
        points.push_back({pixel.surface.positionWorld, pixel.value.x});
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

// An edge of a plate over a floor of side 4. The camera looks down on its shadow, turned along the edge.
struct Edge {
    double height = 1.0;      // of the plate
    double angleDeg = 0.0;    // of its edge against the axes of the shadow map
    double ballRadius = 0.0;  // of a ball under the edge, in place of the floor; 0: the floor
};

struct Ramp {
    double step = 0.0;      // the largest between neighbouring pixels, over the exact ramp's largest
    double backward = 0.0;  // the largest against the ramp's direction
    double teeth = 0.0;     // the largest standard deviation among pixels at one distance from the edge
    double rms = 0.0;       // against the exact share, in the penumbra
    double shift = 0.0;     // the mean error there, which moves the edge
    double texels = 0.0;    // of the shadow map over the penumbra
};

struct SunDisc {
    const char* name;
    const char* preset;
    double diameterDeg;
    glm::dvec3 towards;  // across the edge, to +x
    std::vector<double> heights;
    double roughness = 1.0;  // scales the steps: a low sun's texels of the map are long on the floor
};

// The front of the plate is below, so the camera sees through it.
Ramp rampOf(const Context& context, const Edge& edge, const SunDisc& disc, int width) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(edge.angleDeg), glm::dvec3(0, 1, 0));
    const auto turned = [&](const glm::dvec3& p) { return glm::dvec3(turn * glm::dvec4(p, 0.0)); };
    Scene scene = emptyScene();
    const glm::dvec3 directionToLight = glm::normalize(disc.towards);
    const glm::dvec3 inShadow =
        -edge.height / directionToLight.y * glm::dvec3(directionToLight.x, 0, directionToLight.z);
    if (edge.ballRadius > 0.0)
        addBall(scene, edge.ballRadius, inShadow - glm::dvec3(0, edge.ballRadius, 0));
    else
        addQuad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
    addQuad(scene, turned({0, edge.height, -1.2}), turned({1.6, 0, 0}), turned({0, 0, 2.4}));
    scene = finished(std::move(scene));

    const int rows = 24;
    Settings settings = presetSettings(disc.preset);
    settings.grid = 64;  // voxels do not matter here
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
    for (int x = 3 * width / 8; x < 5 * width / 8; ++x) {
        double sum = 0.0, sumOfSquares = 0.0;
        for (int row = 0; row < rows; ++row) {
            const std::size_t i = static_cast<std::size_t>(row) * width + x;
            const double exact = exactAt(i), step = light[i + 1] - light[i], right = exactAt(i + 1) - exact;
            EXPECT_GE(right, -1e-9);  // the shadow is on the left
            exactStep = std::max(exactStep, right);
            ramp.step = std::max(ramp.step, std::abs(step));
            ramp.backward = std::max(ramp.backward, -step);
            sum += light[i] / rows;
            sumOfSquares += light[i] * light[i] / rows;
            if (exact <= 0.0 || exact >= 1.0) continue;
            errors += light[i] - exact;
            squares += std::pow(light[i] - exact, 2.0);
            ++inPenumbra;
        }
        ramp.teeth = std::max(ramp.teeth, std::sqrt(std::max(sumOfSquares - sum * sum, 0.0)));
    }
    ramp.step /= exactStep;
    ramp.rms = std::sqrt(squares / std::max(inPenumbra, 1));
    ramp.shift = errors / std::max(inPenumbra, 1);
    const double texel = glm::length(scene.boundsWorld.max - scene.boundsWorld.min) / settings.shadowMapSize;
    ramp.texels = 2.0 * radius * edge.height / directionToLight.y / texel;
    return ramp;
}

class Penumbrae : public testing::TestWithParam<SunDisc> {};
const glm::dvec3 slanted(0.3, 1.0, 0.2);
INSTANTIATE_TEST_SUITE_P(SoftShadow, Penumbrae,
                         testing::Values(SunDisc{"mobile5", "mobile", 0.5, slanted, {0.1, 0.5, 2.0}},
                                         SunDisc{"mobile20", "mobile", 2, slanted, {0.1, 0.5, 2.0}},
                                         SunDisc{"mobile50", "mobile", 5, slanted, {0.1, 0.5, 2.0}},
                                         SunDisc{"mobile100", "mobile", 10, slanted, {0.1, 0.5, 2.0}},
                                         SunDisc{"quality20", "quality", 2, slanted, {0.1, 0.5, 2.0}},
                                         SunDisc{"quality100", "quality", 10, slanted, {0.1, 0.5, 2.0}},
                                         SunDisc{"overhead", "mobile", 20, {0, 1, 0}, {0.5}},
                                         SunDisc{"low", "mobile", 5, {0.94, 0.34, 0}, {0.5}, 2.5}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(Penumbrae, AreSmoothRampsAlongAStraightEdge) {
    const SunDisc& disc = GetParam();
    const Context context = openContext(Backend::egl);
    for (const double height : disc.heights)
        for (const double angleDeg : {0.0, 8.0, 45.0, 75.0})
            for (const int width : {1280, 1920}) {
                const Ramp ramp = rampOf(context, {height, angleDeg}, disc, width);
                char what[100];
                std::snprintf(what, sizeof what, "%.1f high, %2.0f degrees, %d pixels", height, angleDeg,
                              width);
                EXPECT_LE(ramp.step, 2.1 * disc.roughness) << what;
                EXPECT_LE(ramp.backward, 0.012 * disc.roughness) << what;
                // Shadows of edges along an axis of the world run along the texels of the map.
                if (angleDeg == 0.0) {
                    EXPECT_LE(ramp.teeth, 0.01) << what;
                }
                // A narrower penumbra is as wide as the map's filter.
                if (ramp.texels > 8.0) {
                    EXPECT_LE(ramp.teeth, 0.04) << what;
                    EXPECT_LE(ramp.rms, 0.06) << what;
                    EXPECT_NEAR(ramp.shift, 0.0, 0.06) << what;
                }
            }
}

TEST(SoftShadow, PenumbraeAreSmoothRampsAcrossABall) {
    const Context context = openContext(Backend::egl);
    for (const char* preset : {"mobile", "quality"})
        for (const double diameterDeg : {0.5, 2.0, 5.0, 10.0})
            for (const double height : {0.1, 0.5, 2.0})
                for (const double angleDeg : {0.0, 45.0}) {
                    const Ramp ramp = rampOf(context, {height, angleDeg, 1.0},
                                             {"", preset, diameterDeg, slanted, {}}, 1920);
                    char what[100];
                    std::snprintf(what, sizeof what, "%s, sun of %.1f, %.1f high, %2.0f degrees", preset,
                                  diameterDeg, height, angleDeg);
                    EXPECT_LE(ramp.step, 2.2) << what;
                    // Narrow penumbrae show the texels of the map.
                    EXPECT_LE(ramp.backward, ramp.texels > 4.0 ? 0.02 : 0.03) << what;
                    if (ramp.texels > 8.0) {
                        EXPECT_LE(ramp.rms, 0.08) << what;
                    }
                }
}

// The strips are narrower than the blocker search and than their penumbra: no point is in full shadow.
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

// Two plates, one behind the other, hide the sun together. The map shows only the upper one where both are.
TEST(SoftShadow, TwoBlockersLetLittleLightThrough) {
    constexpr double upper = 1.0, lower = 0.2, lowerFrom = -0.15, lowerTo = 0.45;
    Scene scene = emptyScene();
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    addQuad(scene, {-1, upper, -1}, {1, 0, 0}, {0, 0, 2});
    addQuad(scene, {lowerFrom, lower, -1}, {lowerTo - lowerFrom, 0, 0}, {0, 0, 2});
    scene = finished(std::move(scene));
    for (const float sunDeg : {0.5F, 2.0F, 5.0F, 10.0F}) {
        const double tangent = std::tan(glm::radians(0.5 * sunDeg));
        ASSERT_LT(upper * tangent, -lowerFrom - lower * tangent);  // no ray passes between the plates
        double most = 0.0;
        int dark = 0;
        for (const Point& point : middleOfFloor(scene, {0, 1, 0}, softMap(sunDeg, 256))) {
            const double texel = 2.0 / 512;
            if (point.positionWorld.x > lowerTo - lower * tangent - 3.0 * texel) continue;
            most = std::max(most, point.light);
            ++dark;
        }
        EXPECT_GT(dark, 5000);
        EXPECT_LE(most, 0.06) << "sun of " << sunDeg << " degrees";
    }
}

// Cascades keep maps of several sizes in one texture, side by side, and no comparison may read over the
// border of a map. Plates stand on both sides of the borders of all cascades. A roof outside of the picture
// makes the search reach far, and would darken receivers that look over a border.
TEST(SoftShadow, CascadesShowWhatOneFineMapShows) {
    Scene scene = emptyScene();
    addQuad(scene, {-8, 0, -8}, {0, 0, 16}, {16, 0, 0});
    for (int x = -6; x <= 6; x += 2)
        for (int z = -6; z <= 6; z += 2)
            addQuad(scene, {x - 0.6, 1.6, z - 0.6}, {1.2, 0, 0}, {0, 0, 1.2});
    addQuad(scene, {-8, 6, -8}, {3, 0, 0}, {0, 0, 16});
    scene = finished(std::move(scene));
    const Context context = openContext(Backend::egl);
    const auto lightWith = [&](int cascades, int mapSize) {
        Settings settings = presetSettings("mobile");
        settings.grid = 64;
        settings.size = {384, 384};
        settings.cascades = cascades;
        settings.shadowMapSize = mapSize;
        settings.shadowConeAngleDeg = 10.0F;
        const Camera above = lookAt({0.5, 6, 0.01}, {0.5, 0, 0}, 90);
        return FrameInspector(context, scene, lightFrom({0.3, 1, 0.2}), settings, above).softShadow();
    };
    const std::vector<float> nested = lightWith(3, 512), fine = lightWith(1, 2048);
    double squares = 0.0, most = 0.0;
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const double error = std::abs(nested[i] - fine[i]);
        squares += error * error / static_cast<double>(fine.size());
        most = std::max(most, error);
    }
    EXPECT_LE(std::sqrt(squares), 0.03);
    EXPECT_LE(most, 0.4);
}

// The sides of a niche are a few texels wide, so the shadow's edge and the side's border are near each other.
TEST(SoftShadow, BordersNearAShadowAreNoCreases) {
    Scene scene = emptyScene();
    const double depth = 0.02;
    addQuad(scene, {-1, -1, 0}, {1, 0, 0}, {0, 3, 0});
    addQuad(scene, {1, -1, 0}, {1, 0, 0}, {0, 3, 0});
    addQuad(scene, {0, 1, 0}, {1, 0, 0}, {0, 1, 0});
    addQuad(scene, {0, -1, 0}, {1, 0, 0}, {0, 1, 0});
    addQuad(scene, {0, 0, -depth}, {1, 0, 0}, {0, 1, 0});
    addQuad(scene, {0, 1, -depth}, {1, 0, 0}, {0, 0, depth});
    addQuad(scene, {0, 0, -depth}, {0, 0, depth}, {1, 0, 0});
    addQuad(scene, {0, 0, -depth}, {0, 1, 0}, {0, 0, depth});  // the side that the sun reaches
    scene = finished(std::move(scene));
    const Context context = openContext(Backend::egl);
    for (const glm::dvec3& sun : {glm::dvec3(0.5, 0.7, 0.6), glm::dvec3(0.5, 0.4, 0.8)}) {
        Settings settings = softMap(0.5F, 256);
        const glm::dvec3 towards = glm::normalize(sun);
        FrameInspector frame(context, scene, lightFrom(towards), settings,
                             lookAt({0.9, 0.5, 0.9}, {0, 0.5, -0.5 * depth}, 45));
        const std::vector<float> light = frame.softShadow();
        int seen = 0, dark = 0;
        for (std::size_t i = 0; i < light.size(); ++i) {
            const glm::dvec3 p = frame.pixels()[i].positionWorld;
            if (!frame.pixels()[i].surface || frame.pixels()[i].normal.x < 0.9) continue;
            const double height = p.y - p.z / towards.z * towards.y;  // where the ray to the sun leaves
            if (height > 0.98) continue;
            ++seen;
            dark += light[i] < 0.5F;
        }
        EXPECT_GT(seen, 500);
        EXPECT_LE(dark, seen / 100) << sun.y;
    }
}

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

}  // namespace
}  // namespace vct::test
