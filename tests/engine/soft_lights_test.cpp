// Soft shadows of lights with a size against rays from each pixel to a disc that faces it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/punctual_light.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

using Type = PunctualLight::Type;

// A plate above a floor of side 4. Its edge is the one that casts the penumbra.
struct Plate {
    double height = 0.5;
    double turnDeg = 0.0;        // turns the edge around the vertical axis
    glm::dvec3 middle{0, 0, 0};  // the middle of the edge, projected to the floor at y = 0

    glm::dvec3 along() const { return {std::sin(glm::radians(turnDeg)), 0, std::cos(glm::radians(turnDeg))}; }
    glm::dvec3 inwards() const { return glm::cross(along(), glm::dvec3(0, 1, 0)) * -1.0; }
    glm::dvec3 onEdge() const { return middle + glm::dvec3(0, height, 0); }
};
constexpr double plateSide = 1.6;

// True if the plate blocks a ray from a point below it.
bool plateBlocks(const Plate& plate, const glm::dvec3& from, const glm::dvec3& towards) {
    if (towards.y <= 0.0) return false;
    const glm::dvec3 at = from + towards * ((plate.height - from.y) / towards.y) - plate.onEdge();
    return glm::dot(at, plate.inwards()) > 0.0 && glm::dot(at, plate.inwards()) < plateSide &&
           std::abs(glm::dot(at, plate.along())) < 0.5 * plateSide;
}

// The share of a light that a point sees. `size`: radius, or tangent of half the angle.
double shareSeen(const PunctualLight& light, double size, const Plate& plate, const glm::dvec3& from) {
    const bool placed = light.type != Type::directional;
    const glm::dvec3 middle =
        placed ? glm::dvec3(light.worldFromLight[3]) - from : glm::dvec3(light.worldFromLight[2]);
    const glm::dvec3 x = glm::normalize(glm::cross(middle, glm::dvec3(0.6, 0, 0.8)));
    const glm::dvec3 y = glm::normalize(glm::cross(middle, x));
    const int rays = 400;
    int seen = 0;
    for (int i = 0; i < rays; ++i) {
        const double radius = size * std::sqrt((i + 0.5) / rays), angle = 2.39996322973 * i;
        const glm::dvec3 towards = middle + radius * (std::cos(angle) * x + std::sin(angle) * y);
        seen += plateBlocks(plate, from, towards) ? 0 : 1;
    }
    return static_cast<double>(seen) / rays;
}

struct SizedLight {
    const char* name;
    PunctualLight light;
    double radius;  // a directional light has secondSunDeg instead
    Plate plate;
    double rms = 0.03;
};
void PrintTo(const SizedLight& sized, std::ostream* out) {
    *out << sized.name;
}

constexpr float secondSunDeg = 6.0F;

class LightsWithASize : public testing::TestWithParam<SizedLight> {};

TEST_P(LightsWithASize, HaveThePenumbraeThatRaysFind) {
    const SizedLight& sized = GetParam();
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    // The floor is so dark that bounces do not matter.
    scene.materials[0].baseColor = glm::vec4(0.04F, 0.04F, 0.04F, 1.0F);
    addQuad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
    // The plate has a lower side only, so that the camera sees through it.
    addQuad(scene, sized.plate.onEdge() - 0.5 * plateSide * sized.plate.along(),
            plateSide * sized.plate.inwards(), plateSide * sized.plate.along());
    scene = finished(std::move(scene));
    scene.punctualLights = {sized.light};
    Settings settings = presetSettings("mobile");
    settings.size = {768, 512};
    settings.lightFrames = 1;
    settings.lightRadius = static_cast<float>(sized.radius);
    settings.shadowConeAngleDeg = secondSunDeg;
    FrameInspector frame(context, scene, darkSun(), settings, lookAt({0, 6, 0.001}, {0, 0, 0}, 30));
    const Image picture = frame.view(Output::giConeShadow);

    const double size =
        sized.light.type == Type::directional ? std::tan(glm::radians(0.5 * secondSunDeg)) : sized.radius;
    double squares = 0.0, errors = 0.0, seenWidth = 0.0, exactWidth = 0.0;
    double exactStep = 0.0, seenStep = 0.0, before = 0.0, exactBefore = 0.0;
    std::size_t last = 0;
    int inPenumbra = 0, wrongOutside = 0, outside = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const SurfacePixel& pixel = frame.pixels()[i];
        if (!pixel.surface || pixel.positionWorld.y > 1e-2) continue;
        const double hard = irradianceOf(sized.light, pixel.positionWorld, {0, 1, 0});
        if (hard < 0.05) continue;
        const double exact = shareSeen(sized.light, size, sized.plate, pixel.positionWorld);
        const double seen = picture.pixels[i].r / pixel.albedo.r / hard;
        if (i == last + 1) {
            exactStep = std::max(exactStep, std::abs(exact - exactBefore));
            seenStep = std::max(seenStep, std::abs(seen - before));
        }
        last = i;
        before = seen;
        exactBefore = exact;
        seenWidth += std::max(seen * (1.0 - seen), 0.0);
        exactWidth += exact * (1.0 - exact);
        if (exact == 0.0 || exact == 1.0) {
            ++outside;
            if (std::abs(seen - exact) > 0.05) ++wrongOutside;
            continue;
        }
        ++inPenumbra;
        squares += std::pow(seen - exact, 2.0);
        errors += seen - exact;
    }
    const double rms = std::sqrt(squares / inPenumbra), mean = errors / inPenumbra;
    EXPECT_GT(inPenumbra, 1000);
    EXPECT_LE(rms, sized.rms);
    EXPECT_NEAR(mean, 0.0, 0.01);
    EXPECT_NEAR(seenWidth / exactWidth, 1.0, 0.15);
    EXPECT_LE(seenStep, 2.5 * exactStep);
    EXPECT_LE(wrongOutside, outside / 500);
}

PunctualLight spotAt(const glm::dvec3& place, const glm::dvec3& target) {
    PunctualLight spot = punctualLightAt(Type::spot, place, target);
    spot.innerConeRad = 0.6;
    spot.outerConeRad = 0.7;
    return spot;
}

INSTANTIATE_TEST_SUITE_P(
    SoftLights, LightsWithASize,
    testing::Values(
        SizedLight{"NearTheFloor", punctualLightAt(Type::point, {0.1, 2, 0.1}, {0, 0, 0}), 0.15, {0.25, 20}},
        SizedLight{"Halfway", punctualLightAt(Type::point, {0.1, 2, 0.1}, {0, 0, 0}), 0.15, {1.0}},
        SizedLight{"Small", punctualLightAt(Type::point, {0.1, 2, 0.1}, {0, 0, 0}), 0.05, {1.0, 30}},
        // Penumbrae over the edges between the sides of a cube.
        SizedLight{"OverSeams",
                   punctualLightAt(Type::point, {0, 1, 0}, {0, 0, 0}),
                   0.1,
                   {0.4, 35, {-0.6, 0, 0}},
                   0.04},
        SizedLight{"Spot", spotAt({-0.3, 2, 0.4}, {0, 0, 0}), 0.1, {0.8, 10}},
        SizedLight{
            "SecondSun", punctualLightAt(Type::directional, {-0.4, 1, 0.2}, {0, 0, 0}), 0.1, {0.8, 20}}),
    [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace vct::test
