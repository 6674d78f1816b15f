// The shadow of a straight edge under a sun with a size, against the exact share of the disc that a point
// sees.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <tuple>

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

}  // namespace
}  // namespace vct::test
