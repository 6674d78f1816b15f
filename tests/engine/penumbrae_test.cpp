// The shadow of a straight edge under a sun with a size, against the exact share of the disc that a point
// sees.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

struct Edge {
    double height = 1.0;    // of the plate over the floor, in units of which the floor has 4
    double angleDeg = 0.0;  // of its edge against the axes of the shadow map
};

// Share of a disc of `radius` that a straight edge leaves over, `distance` from its middle to it.
double shareOfDisc(double distance, double radius) {
    const double t = glm::clamp(distance / radius, -1.0, 1.0);
    return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / pi;
}

struct Ramp {
    double step = 0.0;      // the largest between neighbouring pixels, over the exact ramp's largest
    double backward = 0.0;  // the largest against the ramp's direction
    double rms = 0.0;       // against the exact share, in the penumbra
    double texels = 0.0;    // of the shadow map over the penumbra
};

// Pixels of the middle rows of a picture that looks down on the floor along the edge: the plate's only side
// is its lower one, so that it is not seen.
Ramp rampOf(const Context& context, const Edge& edge, double sunDeg, int width, const std::string& preset) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(edge.angleDeg), glm::dvec3(0, 1, 0));
    const auto turned = [&](const glm::dvec3& p) { return glm::dvec3(turn * glm::dvec4(p, 0.0)); };
    Scene scene = emptyScene();
    addQuad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
    addQuad(scene, turned({0, edge.height, -1.2}), turned({1.6, 0, 0}), turned({0, 0, 2.4}));
    scene = finished(std::move(scene));
    const glm::dvec3 towardsLight = glm::normalize(glm::dvec3(0.3, 1.0, 0.2));
    const glm::dvec3 inShadow = -edge.height / towardsLight.y * glm::dvec3(towardsLight.x, 0, towardsLight.z);

    const int rows = 24;
    Settings settings = presetSettings(preset);
    settings.grid = 64;  // the voxels are not looked at
    settings.size = {width, rows};
    settings.shadowConeAngleDeg = static_cast<float>(sunDeg);
    const double eyeHeight = 20.0, pixel = 4.0 / width;
    Camera camera = lookAt({0, eyeHeight, 0}, {0, 0, -1e-6},
                           glm::degrees(2.0 * std::atan(0.5 * rows * pixel / eyeHeight)));
    camera.worldFromCamera = glm::translate(glm::dmat4(1.0), inShadow) * turn * camera.worldFromCamera;
    FrameInspector frame(context, scene, lightFrom(towardsLight), settings, camera);
    const std::vector<float> light = frame.softShadow();

    const glm::dvec3 onEdge = turned({0, edge.height, 0}), along = turned({0, 0, 1});
    const double radius = std::sin(glm::radians(0.5 * sunDeg));
    const auto exactAt = [&](std::size_t i) {
        const glm::dvec3 normal = glm::normalize(glm::cross(along, onEdge - frame.pixels()[i].positionWorld));
        return shareOfDisc(glm::dot(normal, towardsLight), radius);
    };
    Ramp ramp;
    double exactStep = 0.0, sum = 0.0;
    int inPenumbra = 0;
    for (int row = 0; row < rows; ++row)
        for (int x = width / 4; x < 3 * width / 4; ++x) {
            const std::size_t i = static_cast<std::size_t>(row) * width + x;
            const double exact = exactAt(i), step = light[i + 1] - light[i], right = exactAt(i + 1) - exact;
            EXPECT_GE(right, -1e-9);  // the shadow is on the left
            exactStep = std::max(exactStep, right);
            ramp.step = std::max(ramp.step, std::abs(step));
            ramp.backward = std::max(ramp.backward, -step);
            if (exact <= 0.0 || exact >= 1.0) continue;
            sum += std::pow(light[i] - exact, 2.0);
            ++inPenumbra;
        }
    ramp.step /= exactStep;
    ramp.rms = std::sqrt(sum / std::max(inPenumbra, 1));
    const double texel = glm::length(scene.boundsWorld.max - scene.boundsWorld.min) / settings.shadowMapSize;
    ramp.texels = 2.0 * radius * edge.height / towardsLight.y / texel;
    return ramp;
}

class Penumbrae : public testing::TestWithParam<std::tuple<std::string, double>> {};
INSTANTIATE_TEST_SUITE_P(PresetsAndSuns, Penumbrae,
                         testing::Combine(testing::Values("mobile", "quality"),
                                          testing::Values(0.5, 2.0, 5.0, 10.0)),
                         [](const auto& test) {
                             const int tenths = static_cast<int>(10.0 * std::get<1>(test.param));
                             return std::get<0>(test.param) + std::to_string(tenths);
                         });

// Without levels of the map, or with no light between two, steps of the widest are 8 and 5 times the exact
// ones.
TEST_P(Penumbrae, OfAStraightEdgeAreSmoothRamps) {
    const auto& [preset, sunDeg] = GetParam();
    const Context context = openContext(Backend::egl);
    for (const double height : {0.1, 0.5, 2.0})
        for (const double angleDeg : {0.0, 8.0, 45.0})
            for (const int width : {1280, 1920}) {
                const Ramp ramp = rampOf(context, {height, angleDeg}, sunDeg, width, preset);
                char what[100];
                std::snprintf(what, sizeof what, "%.1f high, %2.0f degrees, %d pixels", height, angleDeg,
                              width);
                std::printf("  %s: steps %.2f, backward %.4f, RMS %.3f, width %.1f texels\n", what, ramp.step,
                            ramp.backward, ramp.rms, ramp.texels);
                EXPECT_LE(ramp.step, 2.0) << what;
                EXPECT_LE(ramp.backward, 0.012) << what;
                // A narrower one is as wide as the map's filter.
                if (ramp.texels > 8.0) {
                    EXPECT_LE(ramp.rms, preset == "mobile" ? 0.07 : 0.05) << what;
                }
            }
}

struct Caster {
    const char* name;
    double height;  // over the floor, whose side is 4
    bool round;     // else the same all along its edges
    std::function<void(Scene&, const glm::dmat4& turn, double height)> add;
    double largest;  // teeth of `mobile`; of `quality`, two thirds
};

// A single-sided rectangle seen from below alone, from x = `from` to `to`, and as far as `end` along z.
void addStrip(Scene& scene, const glm::dmat4& turn, double height, double from, double to, double end) {
    const auto turned = [&](const glm::dvec3& p) { return glm::dvec3(turn * glm::dvec4(p, 0.0)); };
    addQuad(scene, turned({from, height, -end}), turned({to - from, 0, 0}), turned({0, 0, 2.0 * end}));
}

void addPlate(Scene& scene, const glm::dmat4& turn, double height) {
    addStrip(scene, turn, height, 0.0, 1.2, 1.2);
}

void addRod(Scene& scene, const glm::dmat4& turn, double height) {
    addStrip(scene, turn, height, -0.02, 0.02, 1.2);
}

void addSlats(Scene& scene, const glm::dmat4& turn, double height) {
    for (int i = -3; i <= 3; ++i)
        addStrip(scene, turn, height, 0.2 * i - 0.05, 0.2 * i + 0.05, 1.2);
}

void addDisc(Scene& scene, const glm::dmat4& turn, double height) {
    const double radius = 0.4;
    const int rectangles = 64;
    const double half = radius * std::sin(0.5 * pi / rectangles),
                 end = std::sqrt(radius * radius - half * half);
    for (int i = 0; i < rectangles; ++i)
        addStrip(scene, glm::rotate(turn, i * pi / rectangles, glm::dvec3(0, 1, 0)), height, -half, half,
                 end);
}

const Caster casters[] = {
    {"plate, low", 0.3, false, addPlate, 0.02}, {"plate, high", 1.5, false, addPlate, 0.02},
    {"rod", 1.0, false, addRod, 0.02},          {"slats", 0.8, false, addSlats, 0.02},
    {"disc", 0.8, true, addDisc, 0.02},
};

struct Teeth {
    double rms = 0.0;      // of the light about the mean of the pixels that see the same share of the sun
    double largest = 0.0;  // of these means' standard deviations
    int inPenumbra = 0;    // pixels whose mean is between .02 and .98
};

Teeth teethOf(const std::map<int, std::vector<float>>& alike) {
    Teeth teeth;
    double sum = 0.0;
    for (const auto& [key, light] : alike) {
        double mean = 0.0, variance = 0.0;
        for (const float l : light)
            mean += l / static_cast<double>(light.size());
        if (light.size() < 48 || mean < 0.02 || mean > 0.98) continue;
        for (const float l : light)
            variance += (l - mean) * (l - mean);
        sum += variance;
        teeth.inPenumbra += static_cast<int>(light.size());
        teeth.largest = std::max(teeth.largest, std::sqrt(variance / static_cast<double>(light.size())));
    }
    teeth.rms = std::sqrt(sum / std::max(teeth.inPenumbra, 1));
    return teeth;
}

constexpr int casterCount = sizeof casters / sizeof casters[0];

class PenumbraTeeth : public testing::TestWithParam<std::tuple<std::string, int>> {};
INSTANTIATE_TEST_SUITE_P(
    PresetsAndCasters, PenumbraTeeth,
    testing::Combine(testing::Values("mobile", "quality"), testing::Range(0, casterCount)),
    [](const auto& test) {
        std::string name = std::get<0>(test.param) + casters[std::get<1>(test.param)].name;
        name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return c == ' ' || c == ','; }),
                   name.end());
        return name;
    });

TEST_P(PenumbraTeeth, AreSmallAtEverySizeOfTheSun) {
    const auto& [preset, index] = GetParam();
    const Caster& caster = casters[index];
    const Context context = openContext(Backend::egl);
    for (const double angleDeg : {0.0, 15.0, 45.0}) {
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(angleDeg), glm::dvec3(0, 1, 0));
        Scene scene = emptyScene();
        addQuad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
        caster.add(scene, turn, caster.height);
        scene = finished(std::move(scene));
        const glm::dvec3 towardsLight =
            glm::normalize(caster.round ? glm::dvec3(1e-3, 1.0, 1e-3) : glm::dvec3(0.3, 1.0, 0.2));
        const glm::dvec3 inShadow =
            -caster.height / towardsLight.y * glm::dvec3(towardsLight.x, 0, towardsLight.z);

        Settings settings = presetSettings(preset);
        settings.size = {1280, caster.round ? 720 : 96};
        const double eyeHeight = 20.0, pixel = 4.0 / settings.size.x;
        Camera camera = lookAt({0, eyeHeight, 0}, {0, 0, -1e-6},
                               glm::degrees(2.0 * std::atan(0.5 * settings.size.y * pixel / eyeHeight)));
        camera.worldFromCamera = glm::translate(glm::dmat4(1.0), inShadow) * turn * camera.worldFromCamera;
        FrameInspector frame(context, scene, lightFrom(towardsLight), settings, camera);
        for (const float sunDeg : {0.5F, 2.0F, 5.0F, 10.0F}) {
            frame.renderer().setShadowConeAngle(sunDeg);
            const std::vector<float> light = frame.softShadow();
            std::map<int, std::vector<float>> alike;
            for (int y = 0; y < settings.size.y; ++y)
                for (int x = 0; x < settings.size.x; ++x) {
                    const std::size_t i = static_cast<std::size_t>(y) * settings.size.x + x;
                    // The disc is parallel to the floor, but the cone around the sun is not upright: nor are
                    // circles on the floor quite the lines of equal light.
                    const double x0 = x + 0.5 - 0.5 * settings.size.x, y0 = y + 0.5 - 0.5 * settings.size.y;
                    const int key = caster.round ? static_cast<int>(std::hypot(x0, y0)) : x;
                    if (frame.pixels()[i].surface) alike[key].push_back(light[i]);
                }
            const Teeth teeth = teethOf(alike);
            std::printf("  %-8s %-11s %2.0f degrees, sun %4.1f: teeth %.4f, largest %.4f, %d pixels\n",
                        preset.c_str(), caster.name, angleDeg, sunDeg, teeth.rms, teeth.largest,
                        teeth.inPenumbra);
            EXPECT_LE(teeth.rms, caster.largest) << angleDeg << " degrees, sun " << sunDeg;
        }
    }
}

}  // namespace
}  // namespace vct::test
