// Punctual lights, compared with the closed forms of KHR_lights_punctual and with rays.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "image/compare.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/errors.h"
#include "support/frame_inspector.h"
#include "support/playing_scene.h"
#include "support/punctual_light.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

struct Row {
    const char* name;
    std::function<PunctualLight()> make;
};
void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}

class PunctualLightsOnAPlane : public testing::TestWithParam<Row> {};

TEST_P(PunctualLightsOnAPlane, GiveTheIrradianceOfTheExtension) {
    const Context context = openContext(Backend::egl);
    for (const char* preset : {"thesis", "mobile"}) {
        Scene scene = lonePlane(0);
        scene.punctualLights = {GetParam().make()};
        Settings settings = unrefinedPreset(preset);
        settings.grid = 64;
        settings.size = glm::ivec2(96);
        FrameInspector inspector(context, scene, darkSun(), settings, lookAt({0, 3, 0.01}, {0, 0, 0}, 45));
        for (const Output mode : {Output::gi, Output::giConeShadow}) {
            const std::vector<SeenSurface> seen = inspector.seen(mode);
            double brightest = 0.0;
            for (const auto& [surface, light] : seen) {
                const double right = irradianceOf(scene.punctualLights[0], surface.positionWorld, {0, 1, 0});
                brightest = std::max(brightest, right);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(light[c], right * scene.punctualLights[0].color[c], 0.01 * right + 0.001)
                        << preset << ", " << outputName(mode);
            }
            EXPECT_GT(seen.size(), 3000U) << preset;
            EXPECT_GT(brightest, 0.2) << preset;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Lights, PunctualLightsOnAPlane,
    testing::Values(
        Row{"Point", [] { return punctualLightAt(PunctualLight::Type::point, {0.3, 0.8, -0.2}, {0, 0, 0}); }},
        Row{"PointWithARange",
            [] {
                PunctualLight light =
                    punctualLightAt(PunctualLight::Type::point, {0.3, 0.8, -0.2}, {0, 0, 0});
                light.range = 1.2;
                return light;
            }},
        Row{"Spot",
            [] {
                PunctualLight light =
                    punctualLightAt(PunctualLight::Type::spot, {0.6, 1.2, 0.5}, {0.1, 0, 0});
                light.innerConeRad = 0.2;
                light.outerConeRad = 0.5;
                return light;
            }},
        Row{"WideSpot",
            [] {
                PunctualLight light =
                    punctualLightAt(PunctualLight::Type::spot, {0.2, 0.9, 0.1}, {0.1, 0, 0});
                light.innerConeRad = 0.8;
                light.outerConeRad = 1.4;
                return light;
            }},
        Row{"SecondSun",
            [] { return punctualLightAt(PunctualLight::Type::directional, {1, 2, 1}, {0, 0, 0}); }}),
    [](const auto& row) { return row.param.name; });

struct Box {
    glm::dvec3 sides, centre;
};
// A table and its leg.
const Box furniture[] = {{{0.7, 0.05, 0.5}, {0.1, -0.4, 0.1}}, {{0.1, 0.6, 0.1}, {0.1, -0.7, 0.1}}};

// A room with walls without thickness and the furniture.
Scene roomAtNight(std::vector<PunctualLight> lights) {
    Scene scene = closedBox(0);
    scene.materials[0].baseColor = glm::vec4(0.6F, 0.6F, 0.6F, 1.0F);
    for (const Box& box : furniture)
        addBox(scene, box.sides, box.centre);
    scene = finished(std::move(scene));
    scene.punctualLights = std::move(lights);
    return scene;
}

const Camera intoRoom = lookAt({-0.9, 0.6, 0.9}, {0.3, -0.5, -0.2}, 75);

// The furniture is between two points of the room.
bool isBlocked(const glm::dvec3& from, const glm::dvec3& to) {
    return std::any_of(std::begin(furniture), std::end(furniture), [&](const Box& box) {
        const glm::dvec3 a = (box.centre - 0.5 * box.sides - from) / (to - from);
        const glm::dvec3 b = (box.centre + 0.5 * box.sides - from) / (to - from);
        const glm::dvec3 in = glm::min(a, b), out = glm::max(a, b);
        return std::max({in.x, in.y, in.z, 0.0}) < std::min({out.x, out.y, out.z, 1.0});
    });
}

TEST(PunctualLights, HaveTheShadowsThatRaysFindAndLightNoCrease) {
    const Context context = openContext(Backend::egl);
    const std::vector<PunctualLight> lights{
        punctualLightAt(PunctualLight::Type::point, {-0.3, 0.5, 0.2}, {0, 0, 0}),
        punctualLightAt(PunctualLight::Type::point, {0.8, -0.1, -0.7}, {0, 0, 0}),
        punctualLightAt(PunctualLight::Type::spot, {0.4, 0.9, 0.6}, {0.1, -1, 0.1})};
    for (const PunctualLight& light : lights) {
        const Scene scene = roomAtNight({light});
        Settings settings = unrefinedPreset("mobile");
        settings.size = glm::ivec2(256);
        FrameInspector inspector(context, scene, darkSun(), settings, intoRoom);
        const glm::dvec3 place(light.worldFromLight[3]);
        int wrong = 0, judged = 0, litInTheDark = 0;
        for (const auto& [pixel, value] : inspector.seen(Output::shadowMap)) {
            const double right = irradianceOf(light, pixel.positionWorld, pixel.normal);
            if (right < 0.02) continue;
            const bool blocked = isBlocked(pixel.positionWorld + 2e-3 * pixel.normal, place);
            ++judged;
            // Mode 2 adds an ambient light.
            const double seen = (value.r / pixel.albedo.r - 0.05) / right;
            if (std::abs(seen - (blocked ? 0.0 : 1.0)) > 0.02) ++wrong;
            if (blocked && seen > 0.5) ++litInTheDark;
        }
        EXPECT_GT(judged, 15000);
        EXPECT_LE(wrong, judged / 40);  // along the shadows' edges, a texel and a pixel wide
        EXPECT_LE(litInTheDark, judged / 150);
    }
}

// Shares of the pixels that a light reaches by rays which see it as lit: of those in its shadow, and of
// others.
struct LitShares {
    double shadowed, others;
};
LitShares litShares(Renderer& renderer, FrameInspector& inspector, const PunctualLight& light) {
    renderer.render({{Output::shadowMap}, intoRoom});
    const Image picture = renderer.radiance();
    double lit[2] = {}, count[2] = {};
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const SurfacePixel& pixel = inspector.pixels()[i];
        if (!pixel.surface) continue;
        const double right = irradianceOf(light, pixel.positionWorld, pixel.normal);
        if (right < 0.02) continue;
        const bool blocked =
            isBlocked(pixel.positionWorld + 2e-3 * pixel.normal, glm::dvec3(light.worldFromLight[3]));
        const double seen = (picture.pixels[i].r / pixel.albedo.r - 0.05) / right;
        lit[blocked ? 0 : 1] += seen > 0.9 ? 1.0 : 0.0;
        count[blocked ? 0 : 1] += 1.0;
    }
    return {lit[0] / count[0], lit[1] / count[1]};
}

// Sixteen point lights have maps, so the weakest of seventeen casts no shadow. The others are black.
TEST(PunctualLights, PastTheMapsCastNoShadowsAndGetOneWhereThereIsRoom) {
    const Context context = openContext(Backend::egl);
    const PunctualLight weakest = punctualLightAt(PunctualLight::Type::point, {-0.3, 0.5, 0.2}, {0, 0, 0});
    PunctualLight black = punctualLightAt(PunctualLight::Type::point, {0.3, 0.5, 0.2}, {0, 0, 0});
    black.color = glm::vec3(0.0F);
    black.intensity = 50.0F;
    std::vector<PunctualLight> lights(16, black);
    lights.insert(lights.begin() + 5, weakest);
    const Scene scene = roomAtNight(lights);
    Settings settings = unrefinedPreset("mobile");
    settings.size = glm::ivec2(128);
    FrameInspector inspector(context, scene, darkSun(), settings, intoRoom);
    Renderer renderer = makeRenderer(context, scene, darkSun(), settings);
    const LitShares without = litShares(renderer, inspector, weakest);
    EXPECT_GT(without.shadowed, 0.95);
    EXPECT_GT(without.others, 0.95);
    renderer.setPunctualLight(2, std::nullopt);
    const LitShares with = litShares(renderer, inspector, weakest);
    EXPECT_LT(with.shadowed, 0.05);
    EXPECT_GT(with.others, 0.9);
    std::size_t mapBytes = 0;
    for (const Resource& resource : renderer.resources())
        mapBytes += resource.name == "light maps" ? resource.bytes : 0;
    EXPECT_GT(mapBytes, 4U << 20);
    EXPECT_LE(mapBytes, 9U << 19);
}

TEST(PunctualLights, SixtyFourGiveTheSumOfTheirIrradiances) {
    const Context context = openContext(Backend::egl);
    Scene scene = lonePlane(0);
    for (int i = 0; i < 64; ++i) {
        const auto type = i % 3 == 0 ? PunctualLight::Type::spot : PunctualLight::Type::point;
        scene.punctualLights.push_back(
            punctualLightAt(type, {0.2 * (i % 8) - 0.7, 0.6 + 0.01 * i, 0.2 * (i / 8) - 0.7}, {0, 0, 0}));
        scene.punctualLights.back().intensity = 0.1F;
        scene.punctualLights.back().color = glm::vec3(1.0F);
    }
    Settings settings = mobileAt(64);
    settings.size = glm::ivec2(96);
    FrameInspector inspector(context, scene, darkSun(), settings, lookAt({0, 3, 0.01}, {0, 0, 0}, 45));
    const std::vector<SeenSurface> seen = inspector.seen(Output::gi);
    EXPECT_GT(seen.size(), 3000U);
    for (const auto& [surface, light] : seen) {
        double right = 0.0;
        for (const PunctualLight& each : scene.punctualLights)
            right += irradianceOf(each, surface.positionWorld, {0, 1, 0});
        ASSERT_NEAR(light.r, right, 0.01 * right + 0.001);
    }
}

TEST(PunctualLights, ASwitchedOffLightLeavesNothingAfterTheLastStep) {
    const Context context = openContext(Backend::egl);
    const PunctualLight stays = punctualLightAt(PunctualLight::Type::point, {-0.3, 0.5, 0.2}, {0, 0, 0});
    const PunctualLight goes = punctualLightAt(PunctualLight::Type::point, {0.5, 0.2, -0.5}, {0, 0, 0});
    const Scene both = roomAtNight({stays, goes});
    const DirectionalLight none = chooseLight(both);
    for (const char* preset : {"thesis", "mobile"}) {
        Settings settings = unrefinedPreset(preset);
        settings.grid = 64;
        settings.size = glm::ivec2(96);
        Renderer renderer = makeRenderer(context, both, none, settings);
        for (int i = 0; i < settings.lightFrames; ++i)
            renderer.render({{Output::gi}, intoRoom});
        const Image before = renderer.radiance();
        renderer.setLightOn(1, false);
        for (int i = 0; i < settings.lightFrames; ++i)
            renderer.render({{Output::gi}, intoRoom});
        const Image after = renderer.radiance();
        Renderer fresh = makeRenderer(context, both, none, settings);
        fresh.setLightOn(1, false);
        fresh.render({{Output::gi}, intoRoom, LightSteps::all});
        const Image right = fresh.radiance();
        // The sums average the noise of the rays.
        double difference = 0.0, sum = 0.0, change = 0.0;
        for (std::size_t i = 0; i < right.pixels.size(); ++i) {
            difference += after.pixels[i].g - right.pixels[i].g;
            change += std::abs(before.pixels[i].g - right.pixels[i].g);
            sum += right.pixels[i].g;
        }
        EXPECT_GT(change, 0.3 * sum) << preset;
        EXPECT_LE(std::abs(difference), 0.01 * sum) << preset;
    }
}

// One light reaches a part of the scene only, and in the second round an object carries one.
TEST(PunctualLights, VoxelsOfAMovingBoxEqualThoseOfAFreshScene) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    addCube(builder, {0.7F, 0.7F, 0.2F}, {{"translation", {0.4, 0.5, -0.2}}, {"scale", {0.6, 1.0, 0.3}}});
    const int box =
        addCube(builder, {0.8F, 0.1F, 0.1F}, {{"translation", {-1, 0.5, 0}}, {"scale", {0.5, 0.5, 0.5}}});
    builder.animate(box, "translation", {0, 2}, {-1, 0.6F, -1, 1.2F, 0.7F, -0.8F});
    Scene scene = load(builder);
    scene.punctualLights = {punctualLightAt(PunctualLight::Type::point, {0.2, 1.6, 0.4}, {0, 0, 0}),
                            punctualLightAt(PunctualLight::Type::spot, {-1.5, 2.0, 1.0}, {0, 0, 0})};
    scene.punctualLights[1].range = 2.5;
    // This light is so near to static faces that it alone decides the range of the 8 bits.
    scene.punctualLights.push_back(punctualLightAt(PunctualLight::Type::point, {1.8, 0.1, 1.8}, {0, 0, 0}));
    for (const bool carried : {false, true}) {
        if (carried) {
            PunctualLight carriedLight = punctualLightAt(PunctualLight::Type::point, {0, 0, 0}, {0, -1, 0});
            carriedLight.node = 0;
            scene.punctualLights.push_back(posed(carriedLight, poseAt(scene.animation, 0.0)));
        }
        const Settings settings = mobileAt(64);
        PlayingScene stage(context, scene, settings);
        for (const double seconds : {0.0, 0.3, 0.5, 1.6})
            expectFresh(stage, context, scene, settings, seconds, Output::ao);
    }
}

// No object moves, so only the light tells that the maps are out of date.
TEST(PunctualLights, MapsAndVoxelsFollowALightThatMovesAlone) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    addCube(builder, {0.7F, 0.7F, 0.2F}, {{"translation", {0.4, 0.5, -0.2}}, {"scale", {0.6, 1.0, 0.3}}});
    json& lights = builder.document["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"type", "point"}, {"intensity", 4}});
    const int light =
        builder.node({{"translation", {0.2, 1.6, 0.4}},
                      {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
    builder.animate(light, "translation", {0, 2}, {0.2F, 1.6F, 0.4F, -1.2F, 1.2F, -0.5F});
    Scene scene = load(builder);
    ASSERT_EQ(scene.punctualLights.size(), 1U);
    // This light is so near to static faces that it alone decides the range of the 8 bits.
    scene.punctualLights.push_back(punctualLightAt(PunctualLight::Type::point, {1.8, 0.1, 1.8}, {0, 0, 0}));
    const Settings settings = mobileAt(64);
    PlayingScene stage(context, scene, settings);
    for (const double seconds : {0.0, 0.5, 0.5, 1.6})
        expectFresh(stage, context, scene, settings, seconds, Output::ao);
}

TEST(PunctualLights, MoreThanThereIsRoomForIsAnError) {
    const Context context = openContext(Backend::egl);
    const Scene scene = roomAtNight(std::vector<PunctualLight>(
        65, punctualLightAt(PunctualLight::Type::point, {-0.3, 0.5, 0.2}, {0, 0, 0})));
    expectMentions(errorOf([&] { makeRenderer(context, scene, chooseLight(scene), mobileAt(32)); }),
                   {"65 lights besides the sun", "the limit is 64"});
}

}  // namespace
}  // namespace vct::test
