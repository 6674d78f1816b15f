// Light gathered at some of the pixels, brought to all of them: nothing leaks across an edge, nothing is
// black, and any size of picture will do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "scene/camera.h"
#include "support/gathered_frame.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

Settings mobileAt(glm::ivec2 size, int scale) {
    Settings settings = presetSettings("mobile");
    settings.size = size;
    settings.gather.scale = settings.occlusion.scale = scale;
    settings.shadowMapSize = 64;
    return settings;
}

DirectionalLight noLight() {
    DirectionalLight light = lightFrom({0, 1, 0});
    light.intensity = 0.0F;
    return light;
}

GatheredFrame frameOf(const Context& context, const Scene& scene, const Settings& settings,
                      const Camera& camera) {
    return GatheredFrame(context, scene, noLight(), settings, volumeAround(scene.boundsWorld, settings.grid),
                         camera);
}

// A shelf before a wall under a shining ceiling that ends above the shelf's front: its underside and its
// front are black, the wall behind them, parallel to the front, is bright, and meets the floor in a crease.
// No two surfaces are in one plane.
Scene shelf() {
    Scene scene = emptyScene();
    Material emitter = scene.materials[0];
    emitter.emissive = glm::vec3(1.0F);
    scene.materials.push_back(emitter);
    addQuad(scene, {-1.5, 2, -1}, {3, 0, 0}, {0, 0, 1.4}, 1);      // ceiling
    addQuad(scene, {-1.5, 0, -1}, {0, 0, 3}, {3, 0, 0});           // floor
    addQuad(scene, {-1.5, 0, -1}, {3, 0, 0}, {0, 2, 0});           // wall
    addQuad(scene, {-0.6, 1.0, -0.5}, {1.2, 0, 0}, {0, 0, 1.3});   // the shelf from below
    addQuad(scene, {-0.6, 1.15, -0.5}, {0, 0, 1.3}, {1.2, 0, 0});  // from above
    addQuad(scene, {-0.6, 1.0, 0.8}, {1.2, 0, 0}, {0, 0.15, 0});   // its front
    return finished(std::move(scene));
}

// Of every pixel which surface it shows, by plane; -1 for the sky.
std::vector<int> surfacesOf(const std::vector<SurfacePixel>& pixels) {
    std::vector<glm::dvec4> planes;
    std::vector<int> result;
    for (const SurfacePixel& pixel : pixels) {
        if (!pixel.surface) {
            result.push_back(-1);
            continue;
        }
        const glm::dvec4 plane(pixel.normal, glm::dot(pixel.normal, pixel.positionVolume));
        const auto same = [&](const glm::dvec4& other) { return glm::length(other - plane) < 2e-3; };
        const auto found = std::find_if(planes.begin(), planes.end(), same);
        result.push_back(static_cast<int>(found - planes.begin()));
        if (found == planes.end()) planes.push_back(plane);
    }
    return result;
}

// What was measured, with head-room.
struct Bound {
    int scale;
    int leaks;      // pixels
    double change;  // mean
};
class Upsampling : public testing::TestWithParam<Bound> {};
INSTANTIATE_TEST_SUITE_P(Scales, Upsampling,
                         testing::Values(Bound{2, 55, 0.0065}, Bound{4, 5, 0.011}, Bound{6, 6, 0.0125}),
                         [](const auto& test) { return std::to_string(test.param.scale); });

// Every pixel's light is between the least and the most that full resolution has on the same surface nearby.
TEST_P(Upsampling, NothingLeaksAcrossDepthEdgesAndCreases) {
    const int scale = GetParam().scale;
    const Context context = openContext(Backend::egl);
    const Scene scene = shelf();
    const Camera camera = lookAt({0.4, 0.35, 3.4}, {0, 0.85, 0}, 42);
    constexpr int size = 144;
    GatheredFrame full = frameOf(context, scene, mobileAt(glm::ivec2(size), 1), camera);
    GatheredFrame coarse = frameOf(context, scene, mobileAt(glm::ivec2(size), scale), camera);
    const Image right = full.view(VCT_VIEW_INDIRECT);
    const Image image = coarse.view(VCT_VIEW_INDIRECT);
    const std::vector<int> surfaces = surfacesOf(full.pixels());
    ASSERT_EQ(*std::max_element(surfaces.begin(), surfaces.end()), 4)
        << "floor, wall, ceiling, shelf, its front";
    const int reach = 3 * scale;  // of the filter, and of the four neighbours
    int leaks = 0, count = 0;
    double largest = 0.0, change = 0.0, brightest = 0.0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const int surface = surfaces[static_cast<std::size_t>(y) * size + x];
            if (surface < 0) continue;
            float least = 1e9F, most = 0.0F;
            for (int v = std::max(y - reach, 0); v <= std::min(y + reach, size - 1); ++v)
                for (int u = std::max(x - reach, 0); u <= std::min(x + reach, size - 1); ++u) {
                    if (surfaces[static_cast<std::size_t>(v) * size + u] != surface) continue;
                    least = std::min(least, right.at(u, v).x);
                    most = std::max(most, right.at(u, v).x);
                }
            const float value = image.at(x, y).x;
            const double outside = std::max({0.0F, least - value, value - most});
            ++count;
            change += std::abs(value - right.at(x, y).x);
            brightest = std::max<double>(brightest, most);
            largest = std::max(largest, outside);
            // A foreign neighbour weighs a thousandth, which shows only where those of its own weigh as
            // little.
            if (outside > 0.03) ++leaks;
        }
    // Where an edge leaves a gather pixel few neighbours, the mean is over few turns of the cones; and a
    // sliver may find no neighbour of its own.
    EXPECT_LE(leaks, GetParam().leaks);
    EXPECT_LE(change / count, GetParam().change);
    std::printf("scale %d: %d of %d pixels leak, by up to %.3f; mean change %.4f; brightest %.2f\n", scale,
                leaks, count, largest, change / count, brightest);
    ASSERT_GT(brightest, 0.4);
}

// A grille before the sky, finer than the gather's pixels: it sees all of the sky.
TEST(UpsamplingHardCases, ThinRodsBeforeTheSkyAreLit) {
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    for (int i = 0; i < 9; ++i) {
        const double at = -0.97 + 0.231 * i;
        addQuad(scene, {at, -1, 0}, {0.018, 0, 0}, {0.3, 2, 0});
        addQuad(scene, {-1, at, 0.001}, {2, 0.2, 0}, {0, 0.018, 0});
    }
    scene = finished(std::move(scene));
    for (const int scale : {2, 4, 8}) {
        Settings settings = mobileAt({130, 130}, scale);
        settings.skyRadiance = glm::vec3(1.0F);
        GatheredFrame frame = frameOf(context, scene, settings, lookAt({0, 0, 4}, {0, 0, 0}, 40));
        const Image light = frame.view(VCT_VIEW_INDIRECT), openness = frame.view(VCT_VIEW_AO);
        const std::vector<SurfacePixel> pixels = frame.pixels();
        int surfaces = 0, dark = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (!pixels[i].surface) continue;
            ++surfaces;
            dark += light.pixels[i].x < 0.9F || openness.pixels[i].x < 0.9F;
        }
        ASSERT_GT(surfaces, 1000);
        EXPECT_EQ(dark, 0) << "of " << surfaces << " at scale " << scale;
    }
}

// Light that is the same everywhere has one right answer at every pixel of every picture.
TEST(UpsamplingHardCases, AnyPictureSizeAtAnyScale) {
    const Context context = openContext(Backend::egl);
    const Scene scene = lonePlane(0.0);
    struct Case {
        glm::ivec2 size;
        int scale;
    };
    for (const auto& [size, scale] : {Case{{1, 1}, 4}, Case{{3, 5}, 2}, Case{{3, 5}, 4}, Case{{7, 1}, 3},
                                      Case{{1, 9}, 8}, Case{{33, 17}, 4}, Case{{50, 61}, 8}}) {
        Settings settings = mobileAt(size, scale);
        settings.skyRadiance = glm::vec3(0.5F, 1.0F, 2.0F);
        GatheredFrame frame = frameOf(context, scene, settings, lookAt({0, 2, 0.3}, {0, 0, 0}, 30));
        const Image light = frame.view(VCT_VIEW_INDIRECT);
        const std::vector<SurfacePixel> pixels = frame.pixels();
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (!pixels[i].surface) continue;
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(light.pixels[i][c], settings.skyRadiance[c], 1e-3 * settings.skyRadiance[c])
                    << size.x << "x" << size.y << " at scale " << scale << ", pixel " << i;
        }
        ASSERT_TRUE(pixels[pixels.size() / 2].surface);
    }
}

}  // namespace
}  // namespace vct::test
