// Light from a picture of the sky, compared with closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/string_cast.hpp>

#include "engine/environment.h"
#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

// The direction of a pixel of an equirectangular picture; environment.h has the convention.
glm::dvec3 directionOfPixel(double x, double y, int width) {
    const double azimuth = (2.0 * (x + 0.5) / width - 1.0) * pi, polar = 2.0 * (y + 0.5) / width * pi;
    return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

// `radiance`: a function of the direction.
template <class Radiance>
std::shared_ptr<const Environment> skyOf(const Radiance& radiance) {
    Image picture(256, 128);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            picture.at(x, y) = glm::vec3(radiance(directionOfPixel(x, y, picture.width)));
    return std::make_shared<const Environment>(picture, "of a test");
}

// A sky whose channels grow along the axes: red towards +X, green towards +Y, blue towards +Z. The mean over
// the hemisphere of a normal n, weighted by the cosine, is 1/2 + n/3.
glm::dvec3 skyAlongAxes(const glm::dvec3& direction) {
    return 0.5 + 0.5 * direction;
}

Settings settingsUnder(std::shared_ptr<const Environment> sky, int pixels = 48) {
    Settings settings = unrefinedPreset("mobile");
    settings.size = glm::ivec2(pixels);
    settings.shadowMapSize = 64;
    settings.environment = std::move(sky);
    return settings;
}

glm::dvec3 meanOf(FrameInspector& frame, Output output) {
    const std::vector<SeenSurface> seen = frame.seen(output);
    EXPECT_GT(seen.size(), 300U);
    glm::dvec3 sum(0.0);
    for (const SeenSurface& pixel : seen)
        sum += pixel.value;
    return sum / static_cast<double>(seen.size());
}

void expectNear(const glm::dvec3& found, const glm::dvec3& right, double tolerance = 0.02) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], right[c], tolerance * std::max(right[c], 0.5));
}

// The irradiance of a white square under a sky.
glm::dvec3 irradianceOfPlane(const Context& context, const glm::dvec3& normal,
                             const std::shared_ptr<const Environment>& sky) {
    Scene scene = emptyScene();
    const glm::dvec3 helper = std::abs(normal.y) > 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, normal)), v = glm::cross(normal, u);
    addQuad(scene, -u - v, 2.0 * u, 2.0 * v);
    FrameInspector frame(context, finished(std::move(scene)), noLight(), settingsUnder(sky),
                         lookAt(3.0 * normal + 0.01 * u, {0, 0, 0}, 30));
    return meanOf(frame, Output::indirectLight);
}

// Any turn, reflection or exchange of two axes of the sky gives another answer.
TEST(Sky, PlanesTowardsSixSidesReceiveTheClosedFormOfASkyThatGrowsAlongTheAxes) {
    const Context context = openContext(Backend::egl);
    const auto sky = skyOf(skyAlongAxes);
    for (const glm::dvec3& normal :
         {glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
        SCOPED_TRACE(glm::to_string(normal));
        expectNear(irradianceOfPlane(context, normal, sky), 0.5 + normal / 3.0);
    }
}

// The radiance is 1 above the horizon: the share of a plane's hemisphere above it is (1 + n.y) / 2.
TEST(Sky, ALeaningPlaneReceivesTheBrightHalf) {
    const Context context = openContext(Backend::egl);
    const auto sky = skyOf([](const glm::dvec3& d) { return glm::dvec3(d.y > 0.0 ? 1.0 : 0.0); });
    for (const double degrees : {30.0, 60.0, 90.0}) {
        SCOPED_TRACE(degrees);
        const double angle = glm::radians(degrees);
        const glm::dvec3 normal(std::sin(angle), std::cos(angle), 0.0);
        expectNear(irradianceOfPlane(context, normal, sky), glm::dvec3(0.5 * (1.0 + normal.y)));
    }
}

// A sun of one pixel gives L omega cos(theta) / pi. The few directions near it decide the error.
TEST(Sky, AFloorReceivesASunOfOnePixelInTheMean) {
    const Context context = openContext(Backend::egl);
    constexpr int width = 256;
    double sum = 0.0;
    const std::pair<int, int> suns[] = {{10, 40}, {77, 20}, {130, 31}, {200, 45}, {250, 10}};
    for (const auto& [x, y] : suns) {
        Image picture(width, width / 2);
        const glm::dvec3 direction = directionOfPixel(x, y, width);
        const double step = 2.0 * pi / width;
        const double solidAngle = step * (std::cos(y * step) - std::cos((y + 1) * step));
        picture.at(x, y) = glm::vec3(pi / (solidAngle * direction.y));
        const auto sky = std::make_shared<const Environment>(picture, "of a test");
        sum += irradianceOfPlane(context, {0, 1, 0}, sky).r / static_cast<double>(std::size(suns));
    }
    EXPECT_NEAR(sum, 1.0, 0.15);
}

const Camera aboveRoom = lookAt({0, 3.5, 0.001}, {0, 0, 0}, 28);

// A white room of 2 x 2 without a ceiling.
Scene openRoom() {
    Scene scene = emptyScene();
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    addQuad(scene, {-1, 0, -1}, {0, 1, 0}, {0, 0, 2});
    addQuad(scene, {1, 0, -1}, {0, 0, 2}, {0, 1, 0});
    addQuad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1, 0});
    addQuad(scene, {-1, 0, 1}, {0, 1, 0}, {2, 0, 0});
    return finished(std::move(scene));
}

// As in a white furnace, every surface is as bright as the sky.
TEST(Sky, AWhiteOpenRoomIsAsBrightAsTheSky) {
    const Context context = openContext(Backend::egl);
    const auto sky = skyOf([](const glm::dvec3&) { return glm::dvec3(1.0); });
    Settings settings = settingsUnder(sky);
    settings.lightFrames = 64;
    FrameInspector frame(context, openRoom(), noLight(), settings, aboveRoom);
    EXPECT_NEAR(meanOf(frame, Output::gi).r, 1.0, 0.02);
}

TEST(Sky, MirrorsAndTheBackgroundShowItPixelByPixel) {
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    scene.materials[0].metallic = 1.0F;
    scene.materials[0].roughness = 0.0F;
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    const Camera above = lookAt({0.4, 1.0, 2.0}, {0, 0.2, 0}, 60);
    FrameInspector frame(context, finished(std::move(scene)), noLight(),
                         settingsUnder(skyOf(skyAlongAxes), 64), above);
    const Image image = frame.view(Output::gi);
    const double tanHalf = std::tan(glm::radians(30.0));
    int mirrored = 0, background = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::dvec3 inCamera(((x + 0.5) / 32.0 - 1.0) * tanHalf, (1.0 - (y + 0.5) / 32.0) * tanHalf,
                                      -1.0);
            glm::dvec3 direction = glm::normalize(glm::dmat3(above.worldFromCamera) * inCamera);
            const SurfacePixel& pixel = frame.pixels()[static_cast<std::size_t>(y) * 64 + x];
            if (pixel.surface) {
                // The border of a thin plane covers its voxels in part.
                const glm::dvec3& p = pixel.positionWorld;
                if (std::max(std::abs(p.x), std::abs(p.z)) > 0.9) continue;
                direction.y = -direction.y;
            }
            ++(pixel.surface ? mirrored : background);
            const glm::dvec3 right = skyAlongAxes(direction);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(image.at(x, y)[c], right[c], 0.01)
                    << x << "," << y << (pixel.surface ? " mirror" : " sky");
        }
    EXPECT_GT(background, 1000);
    EXPECT_GT(mirrored, 300);
}

// The light that a white metal reflects from a sky (glTF 2.0, appendix B): the midpoint rule over the
// hemisphere, weighted by the cosine. All vectors have unit length.
template <class Radiance>
double reflectedSky(const Radiance& radiance, double roughness, const glm::dvec3& normal,
                    const glm::dvec3& view) {
    const double alpha2 = std::pow(roughness, 4.0), cosView = glm::dot(normal, view);
    const glm::dvec3 side = glm::normalize(glm::cross(normal, glm::dvec3(0.6, 0.0, 0.8)));
    const auto masking = [&](double cosine) {
        return 1.0 / (cosine + std::sqrt(alpha2 + (1.0 - alpha2) * cosine * cosine));
    };
    constexpr int count = 64;
    double sum = 0.0;
    for (int i = 0; i < count * count; ++i) {
        const double square = (i / count + 0.5) / count, turn = 2.0 * pi * (i % count + 0.5) / count;
        const double height = std::sqrt(1.0 - square);
        const glm::dvec3 light =
            height * normal +
            std::sqrt(square) * (std::cos(turn) * side + std::sin(turn) * glm::cross(normal, side));
        const double cosFacet = glm::dot(normal, glm::normalize(light + view));
        const double d = cosFacet * cosFacet * (alpha2 - 1.0) + 1.0;
        sum += alpha2 / (d * d) * masking(height) * masking(cosView) * radiance(light);
    }
    return sum / (count * count);
}

// The highlight of a glow in the sky fades and widens as the lobe of GGX does, up to the roughness 1.
TEST(Sky, ABallOfMetalReflectsTheLobeOfItsRoughness) {
    const Context context = openContext(Backend::egl);
    const auto glow = [](const glm::dvec3& direction) {
        return 0.2 + 4.0 * std::pow(std::max(glm::dot(direction, {0.48, 0.6, 0.64}), 0.0), 32.0);
    };
    for (const float roughness : {0.5F, 1.0F}) {
        SCOPED_TRACE(roughness);
        Scene scene = emptyScene();
        scene.materials[0].baseColor = glm::vec4(1.0F);
        scene.materials[0].metallic = 1.0F;
        scene.materials[0].roughness = roughness;
        addBall(scene, 0.8, {0, 0, 0});
        const Settings settings = settingsUnder(skyOf(glow), 96);
        const glm::dvec3 eye(0.0, 0.5, 3.0);
        FrameInspector frame(context, finished(std::move(scene)), noLight(), settings,
                             lookAt(eye, {0, 0, 0}, 35));
        double squares = 0.0, sum = 0.0, right = 0.0;
        int count = 0;
        for (const auto& [surface, light] : frame.seen(Output::gi)) {
            const glm::dvec3 normal = glm::normalize(surface.positionWorld);
            const glm::dvec3 view = glm::normalize(eye - surface.positionWorld);
            if (glm::dot(normal, view) < 0.3) continue;
            const double expected = reflectedSky(glow, roughness, normal, view);
            squares += std::pow(light.g - expected, 2.0);
            sum += light.g;
            right += expected;
            ++count;
        }
        ASSERT_GT(count, 1000);
        EXPECT_LT(std::sqrt(squares * count) / right, 0.08);
        EXPECT_NEAR(sum / right, 1.0, 0.03);
    }
}

// One pixel is a sun that is too bright for half floats.
TEST(Environment, EveryLevelHoldsTheWholeLight) {
    for (const auto& [x, y] : {std::pair{0, 0}, {13, 7}, {40, 16}, {63, 31}}) {
        constexpr int width = 64;
        Image picture(width, width / 2, glm::vec3(0.1F));
        picture.at(x, y) = glm::vec3(1e6F);
        const Environment sky(picture, "of a test");
        const double step = 2.0 * pi / width;
        const double right =
            4.0 * pi * 0.1 + (1e6 - 0.1) * step * (std::cos(y * step) - std::cos((y + 1) * step));
        for (int level = 0; level < sky.levels(); ++level) {
            const int side = sky.side(level);
            double sum = 0.0;
            for (std::size_t i = 0; i < sky.texels(level).size(); ++i) {
                // The texel's solid angle from 8 x 8 places in it.
                double solidAngle = 0.0;
                for (int place = 0; place < 64; ++place) {
                    const double s =
                        2.0 * (static_cast<double>(i % side) + (place % 8 + 0.5) / 8.0) / side - 1.0;
                    const double t =
                        2.0 * (static_cast<double>(i / side % side) + (place / 8 + 0.5) / 8.0) / side - 1.0;
                    solidAngle += std::pow(1.0 + s * s + t * t, -1.5) / (16.0 * side * side);
                }
                sum += sky.texels(level)[i].r * solidAngle;
            }
            EXPECT_NEAR(sum / right, 1.0, y == 0 || y == 31 ? 0.15 : 0.02)
                << x << "," << y << " level " << level;
        }
    }
}

}  // namespace
}  // namespace vct::test
