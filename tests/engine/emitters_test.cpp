// Compact emitters: surfaces that emit light, whose parts the faces sample by cones of their own.
#include "engine/emitters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/frame_inspector.h"
#include "support/playing_scene.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr float emitterRadiance = 20.0F, roomAlbedo = 0.5F;

int addEmissiveMaterial(Scene& scene, float radiance = emitterRadiance) {
    Material emitter;
    emitter.baseColor = glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);
    emitter.emissive = glm::vec3(radiance);
    scene.materials.push_back(emitter);
    return static_cast<int>(scene.materials.size()) - 1;
}

// A room of side 2 with a square emitter that faces down.
Scene roomWithEmitter(double side, double height = 0.98) {
    Scene scene = closedBox(0);
    scene.materials[0].baseColor = glm::vec4(glm::vec3(roomAlbedo), 1.0F);
    const double h = side / 2.0;
    addQuad(scene, {-h, height, -h}, {side, 0, 0}, {0, 0, side}, addEmissiveMaterial(scene));
    return finished(std::move(scene));
}

std::vector<EmitterPart> partsAt64(const Scene& scene) {
    return emitterParts(scene, volumeAround(scene.boundsWorld, 64));
}

TEST(EmitterParts, ASmallBoxIsOnePartWithoutADirection) {
    Scene scene = closedBox(0);
    addBox(scene, glm::dvec3(0.1), {0.2, 0.1, 0.3}, addEmissiveMaterial(scene));
    const std::vector<EmitterPart> parts = partsAt64(finished(std::move(scene)));
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_TRUE(parts[0].isRound());
    EXPECT_NEAR(parts[0].area, 0.06, 1e-6);
    EXPECT_NEAR(glm::distance(parts[0].centre, glm::dvec3(0.2, 0.1, 0.3)), 0.0, 1e-6);
}

TEST(EmitterParts, AnEmittingWallHasNone) {
    EXPECT_TRUE(partsAt64(roomWithEmitter(2.0)).empty());
}

// A panel, and panels that need all parts together: in a grid of 256 each would have more than a hundred.
TEST(EmitterParts, StayCompactInAFinerGrid) {
    const auto compact = [](const Scene& scene, int grid) {
        const std::vector<bool> emitting =
            emittingInstances(scene, emitterParts(scene, volumeAround(scene.boundsWorld, grid)));
        return std::count(emitting.begin(), emitting.end(), true);
    };
    Scene many = closedBox(0);
    for (int i = 0; i < 8; ++i)
        addQuad(many, {-0.9 + 0.45 * (i % 4), 0.98, -0.5 + 0.6 * (i / 4)}, {0.4, 0, 0}, {0, 0, 0.4},
                addEmissiveMaterial(many));
    many = finished(std::move(many));
    for (const auto& [scene, count] : {std::pair{roomWithEmitter(0.6), 1}, {many, 8}})
        for (const int grid : {64, 128, 256})
            EXPECT_EQ(compact(scene, grid), count) << grid;
    EXPECT_GT(emitterParts(roomWithEmitter(0.2), volumeAround({glm::dvec3(-1), glm::dvec3(1)}, 128)).size(),
              partsAt64(roomWithEmitter(0.2)).size());
}

TEST(EmitterParts, TheBrightestOfManyAreTaken) {
    Scene scene = closedBox(0);
    for (int i = 0; i < 40; ++i) {
        const double x = -0.9 + 0.2 * (i % 8), z = -0.9 + 0.3 * (i / 8);
        addQuad(scene, {x, 0.9, z}, {0.05, 0, 0}, {0, 0, 0.05},
                addEmissiveMaterial(scene, static_cast<float>(1 + i)));
    }
    scene = finished(std::move(scene));
    const std::vector<EmitterPart> parts = partsAt64(scene);
    ASSERT_EQ(parts.size(), std::size_t{VCT_MAX_EMITTER_PARTS});
    for (const EmitterPart& part : parts)
        EXPECT_GT(part.radiance.g, 40.5 - VCT_MAX_EMITTER_PARTS);
}

TEST(EmitterParts, ATextureScalesTheFlux) {
    Scene scene = roomWithEmitter(0.2);
    Texture halfLit;
    halfLit.width = 2;
    halfLit.height = 1;
    halfLit.rgba = std::vector<std::uint8_t>{255, 255, 255, 255, 0, 0, 0, 255};
    scene.textures.push_back(halfLit);
    scene.materials.back().emissiveTexture = 0;
    Mesh& mesh = scene.meshes.back();
    for (Vertex& vertex : mesh.vertices)
        vertex.emissiveUv = {vertex.position.x > 0.0F ? 1.0F : 0.0F, 0.0F};
    double flux = 0.0;
    for (const EmitterPart& part : partsAt64(scene))
        flux += part.flux();
    EXPECT_NEAR(flux, 0.5 * emitterRadiance * 0.04, 0.05 * emitterRadiance * 0.04);
}

// Share of the hemisphere over a point that a square fills, which lies above the origin; by many points.
double shareOfSquare(const glm::dvec3& from, double side, double height) {
    constexpr int points = 32;
    double sum = 0.0;
    for (int i = 0; i < points * points; ++i) {
        const glm::dvec3 at((i % points + 0.5) / points * side - side / 2.0, height,
                            (i / points + 0.5) / points * side - side / 2.0);
        const glm::dvec3 ray = at - from;
        sum += ray.y * ray.y / (pi * glm::dot(ray, ray) * glm::dot(ray, ray));
    }
    return sum * side * side / (points * points);
}

// A plate of side 0.6 at the height 0 hides a point of the emitter from a point of the floor.
bool plateHides(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 at = glm::mix(from, to, (0.0 - from.y) / (to.y - from.y));
    return std::max(std::abs(at.x), std::abs(at.z)) < 0.3;
}

TEST(Emitters, LightAFloorByTheirFormFactor) {
    const Context context = openContext(Backend::egl);
    // The second emitter fills much of the hemisphere, and is only three voxels away.
    for (const auto& [side, height] : {std::pair{0.1, 0.98}, {0.5, -0.9}}) {
        SCOPED_TRACE(testing::Message() << side << " wide at " << height);
        const Settings settings = mobileAt(64);
        FrameInspector inspector(context, roomWithEmitter(side, height), noLight(), settings,
                                 lookAt({0, 0.5, 0.01}, {0, -1, 0}, 60));
        for (const auto& [surface, light] : inspector.seen(Output::indirectLight)) {
            const glm::dvec3& p = surface.positionWorld;
            if (p.y > -0.99) continue;
            const double right = roomAlbedo * emitterRadiance * shareOfSquare(p, side, height);
            // Light is interpolated between the middles of faces.
            const double brightest = roomAlbedo * emitterRadiance * shareOfSquare({0, -1, 0}, side, height);
            ASSERT_NEAR(light.g, right, 0.03 * (height < -0.8 ? brightest : right)) << p.x << " " << p.z;
        }
    }
}

// A lamp in a closed room adds a thousandth of what the sun gives outside, by day and after sunset.
TEST(Emitters, KeepDimLightBesideTheSun) {
    const Context context = openContext(Backend::egl);
    DirectionalLight sun = noLight();
    sun.intensity = static_cast<float>(1000.0 * pi * emitterRadiance);
    FrameInspector inspector(context, roomWithEmitter(0.5), sun, mobileAt(64),
                             lookAt({0, 0.5, 0.01}, {0, -1, 0}, 60));
    for (const float illuminance : {sun.intensity, 0.0F}) {
        SCOPED_TRACE(illuminance);
        inspector.renderer().setSunlight(glm::vec3(1), illuminance);
        const double unit = inspector.renderer().radianceScale();
        int count = 0;
        for (const auto& [surface, light] : inspector.seen(Output::indirectLight)) {
            const double right =
                roomAlbedo * emitterRadiance * shareOfSquare(surface.positionWorld, 0.5, 0.98);
            if (surface.positionWorld.y > -0.99) continue;
            ++count;
            ASSERT_NEAR(light.g * unit, right, 0.03 * right);
        }
        EXPECT_GT(count, 2000);
    }
}

TEST(Emitters, CastTheShadowsThatRaysFind) {
    const Context context = openContext(Backend::egl);
    Scene scene = roomWithEmitter(0.4);
    addBox(scene, {0.6, 0.02, 0.6}, {0, 0, 0});
    scene = finished(std::move(scene));
    const Settings settings = mobileAt(96);
    FrameInspector inspector(context, scene, noLight(), settings, lookAt({0.9, -0.2, 0.9}, {0, -1, 0}, 80));
    double squares = 0.0, brightest = 0.0;
    int count = 0, inUmbra = 0;
    for (const auto& [surface, light] : inspector.seen(Output::indirectLight)) {
        const glm::dvec3 place = surface.positionWorld;
        if (place.y > -0.99) continue;
        int seen = 0;
        for (int k = 0; k < 256; ++k)
            seen +=
                plateHides(place, {0.4 * (k % 16 + 0.5) / 16 - 0.2, 0.98, 0.4 * (k / 16 + 0.5) / 16 - 0.2})
                    ? 0
                    : 1;
        const double unhidden = roomAlbedo * emitterRadiance * shareOfSquare(place, 0.4, 0.98);
        const double right = unhidden * seen / 256.0;
        brightest = std::max(brightest, unhidden);
        squares += std::pow(light.g - right, 2.0);
        ++count;
        if (seen == 0 && std::max(std::abs(place.x), std::abs(place.z)) < 0.25) {
            ++inUmbra;
            EXPECT_LT(light.g, 0.1 * unhidden);
        }
    }
    ASSERT_GT(count, 2000);
    EXPECT_GT(inUmbra, 100);
    EXPECT_LT(std::sqrt(squares / count), 0.06 * brightest);
}

TEST(Emitters, AreInAMirrorAtTheirPlaceAndAsBright) {
    const Context context = openContext(Backend::egl);
    Scene scene = roomWithEmitter(0.4);
    Material mirror;
    mirror.metallic = 1.0F;
    mirror.roughness = 0.05F;
    scene.materials.push_back(mirror);
    addQuad(scene, {-0.9, -0.95, -0.9}, {0, 0, 1.8}, {1.8, 0, 0},
            static_cast<int>(scene.materials.size()) - 1);
    scene = finished(std::move(scene));
    const Settings settings = mobileAt(96);
    FrameInspector inspector(context, scene, noLight(), settings, lookAt({0, 0.6, 0.01}, {0, -1, 0}, 60));
    int inside = 0, outside = 0;
    for (const auto& [surface, light] : inspector.seen(Output::gi)) {
        const glm::dvec3 place = surface.positionWorld;
        if (place.y > -0.94 || place.y < -0.96) continue;
        // The eye behind the mirror is at -0.95 - (0.6 + 0.95).
        const glm::dvec3 eye(0, -2.5, 0.01);
        const glm::dvec3 met = glm::mix(eye, place, (0.98 - eye.y) / (place.y - eye.y));
        const double across = std::max(std::abs(met.x), std::abs(met.z));
        if (across < 0.15) {
            ++inside;
            EXPECT_NEAR(light.g, emitterRadiance, 0.1 * emitterRadiance);
        } else if (across > 0.28 && across < 0.5) {
            ++outside;
            EXPECT_LT(light.g, 0.2 * emitterRadiance);
        }
    }
    EXPECT_GT(inside, 50);
    EXPECT_GT(outside, 50);
}

// Light of a square emitter of radiance 1 that faces down at `height`, reflected by a white metal at a point
// of a plane (glTF 2.0, appendix B).
double squareInLobe(const glm::dvec3& place, const glm::dvec3& eye, double roughness, double side,
                    double height) {
    const double alpha2 = std::pow(roughness, 4.0);
    const glm::dvec3 view = glm::normalize(eye - place);
    const auto masking = [&](double cosine) {
        return 1.0 / (cosine + std::sqrt(alpha2 + (1.0 - alpha2) * cosine * cosine));
    };
    constexpr int count = 32;
    double met = 0.0;
    for (int i = 0; i < count * count; ++i) {
        const glm::dvec2 u((i % count + 0.5) / count, (i / count + 0.5) / count);
        const glm::dvec3 offset = glm::dvec3(side * (u.x - 0.5), height, side * (u.y - 0.5)) - place;
        const glm::dvec3 light = glm::normalize(offset), facet = glm::normalize(light + view);
        const double d = facet.y * facet.y * (alpha2 - 1.0) + 1.0;
        const double brdf = alpha2 / (pi * d * d) * masking(light.y) * masking(view.y);
        met += brdf * light.y * light.y * side * side / glm::dot(offset, offset);
    }
    return met / (count * count);
}

// A few rays would find a copy of the emitter each.
TEST(Emitters, AreBlurredWithoutCopiesByARoughMetal) {
    const Context context = openContext(Backend::egl);
    for (const double side : {0.1, 0.4}) {
        SCOPED_TRACE(side);
        Scene scene = roomWithEmitter(side);
        scene.materials[0].baseColor = glm::vec4(0, 0, 0, 1);
        Material metal;
        metal.metallic = 1.0F;
        metal.roughness = 0.5F;
        scene.materials.push_back(metal);
        addQuad(scene, {-0.9, -0.95, -0.9}, {0, 0, 1.8}, {1.8, 0, 0},
                static_cast<int>(scene.materials.size()) - 1);
        scene = finished(std::move(scene));
        const glm::dvec3 eye(0, 0.6, 0.8);
        FrameInspector inspector(context, scene, noLight(), mobileAt(96), lookAt(eye, {0, -1, 0}, 60));
        double squares = 0.0, brightest = 0.0, worst = 0.0;
        int count = 0;
        for (const auto& [surface, light] : inspector.seen(Output::gi)) {
            const glm::dvec3& place = surface.positionWorld;
            if (place.y > -0.94 || place.y < -0.96) continue;
            const double right = emitterRadiance * squareInLobe(place, eye, 0.5, side, 0.98);
            brightest = std::max(brightest, right);
            squares += std::pow(light.g - right, 2.0);
            worst = std::max(worst, std::abs(light.g - right));
            ++count;
        }
        ASSERT_GT(count, 2000);
        EXPECT_LT(std::sqrt(squares / count), 0.05 * brightest);
        EXPECT_LT(worst, 0.2 * brightest);
    }
}

TEST(Emitters, LeaveNoLightWhereTheyWere) {
    const Context context = openContext(Backend::egl);
    Scene scene = roomWithEmitter(0.2);
    scene.animation.nodes.emplace_back();
    AnimationChannel channel;
    channel.node = 0;
    channel.path = AnimationChannel::Path::translation;
    channel.times = {0.0, 1.0};
    channel.values = {glm::dvec4(-0.7, 0, 0, 0), glm::dvec4(0.7, 0, 0, 0)};
    scene.animation.channels.push_back(channel);
    scene.instances.back().node = 0;
    scene.cameras.push_back(lookAt({0, 0, 0.95}, {0, -1, 0}, 90));
    scene.lights = {noLight()};
    scene = finished(std::move(scene));
    const Settings settings = mobileAt(48);
    PlayingScene stage(context, scene, settings);
    stage.convergedAt(0.0);
    expectFreshLight(stage, context, scene, settings, 1.0);
}

}  // namespace
}  // namespace vct::test
