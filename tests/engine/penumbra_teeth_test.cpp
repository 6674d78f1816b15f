// Borders of soft shadows are smooth along what casts them: pixels that see the same share of the sun have
// the same light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

struct Caster {
    const char* name;
    double height;  // over the floor, whose side is 4
    bool round;     // else the same all along its edges
    std::function<void(Scene&, const glm::dmat4& turn, double height)> add;
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
    {"plate, low", 0.3, false, addPlate}, {"plate, high", 1.5, false, addPlate}, {"rod", 1.0, false, addRod},
    {"slats", 0.8, false, addSlats},      {"disc", 0.8, true, addDisc},
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

// Out of levels whose texels hold the depth of one place in them each, teeth of .025 to .06, and of .24 under
// the rod, which the search loses.
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
        const glm::dvec3 directionToLight =
            glm::normalize(caster.round ? glm::dvec3(1e-3, 1.0, 1e-3) : glm::dvec3(0.3, 1.0, 0.2));
        const glm::dvec3 inShadow =
            -caster.height / directionToLight.y * glm::dvec3(directionToLight.x, 0, directionToLight.z);

        Settings settings = presetSettings(preset);
        settings.size = {1280, caster.round ? 720 : 96};
        const double eyeHeight = 20.0, pixel = 4.0 / settings.size.x;
        Camera camera = lookAt({0, eyeHeight, 0}, {0, 0, -1e-6},
                               glm::degrees(2.0 * std::atan(0.5 * settings.size.y * pixel / eyeHeight)));
        camera.worldFromCamera = glm::translate(glm::dmat4(1.0), inShadow) * turn * camera.worldFromCamera;
        FrameInspector frame(context, scene, lightFrom(directionToLight), settings, camera);
        for (const float sunDeg : {0.5F, 2.0F, 5.0F, 10.0F}) {
            frame.renderer().setShadowConeAngle(sunDeg);
            const std::vector<float> light = frame.softShadow();
            std::map<int, std::vector<float>> alike;
            for (int y = 0; y < settings.size.y; ++y)
                for (int x = 0; x < settings.size.x; ++x) {
                    const std::size_t i = static_cast<std::size_t>(y) * settings.size.x + x;
                    // The sun is above the disc, and beside the others.
                    const double x0 = x + 0.5 - 0.5 * settings.size.x, y0 = y + 0.5 - 0.5 * settings.size.y;
                    const int key = caster.round ? static_cast<int>(std::hypot(x0, y0)) : x;
                    if (frame.pixels()[i].surface) alike[key].push_back(light[i]);
                }
            const Teeth teeth = teethOf(alike);
            const double texel =
                glm::length(scene.boundsWorld.max - scene.boundsWorld.min) / settings.shadowMapSize;
            const double texels =
                2.0 * std::sin(glm::radians(0.5 * sunDeg)) * caster.height / directionToLight.y / texel;
            // A narrower one is as ragged as the map's own texels.
            if (texels > 8.0) {
                EXPECT_GT(teeth.inPenumbra, 1000);
                EXPECT_LE(teeth.rms, 0.025) << angleDeg << " degrees, sun " << sunDeg;
                EXPECT_LE(teeth.largest, 0.04) << angleDeg << " degrees, sun " << sunDeg;
            }
        }
    }
}

}  // namespace
}  // namespace vct::test
