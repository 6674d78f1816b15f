// The gather through directional coverage voxels against answers that need no renderer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "scene/camera.h"
#include "support/gathered_frame.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr double pi = 3.14159265358979323846;

// Large enough that what is measured is the gather: at a sixth of the pixels, 64 x 64 of them.
constexpr int pictureSide = 384;

Settings presetAt(const std::string& preset, glm::ivec2 size) {
    Settings settings = presetSettings(preset);
    settings.size = size;
    settings.shadowMapSize = 256;
    return settings;
}

DirectionalLight noLight() {
    DirectionalLight light = lightFrom({0, 1, 0});
    light.intensity = 0.0F;
    return light;
}

// Adds a material that emits radiance 1, and returns its index.
int addEmitter(Scene& scene) {
    Material emitter = scene.materials[0];
    emitter.emissive = glm::vec3(1.0F);
    scene.materials.push_back(emitter);
    return static_cast<int>(scene.materials.size()) - 1;
}

GatheredFrame frameOf(const Context& context, const Scene& scene, const DirectionalLight& light,
                      const Settings& settings, const Camera& camera) {
    return GatheredFrame(context, scene, light, settings, volumeAround(scene.boundsWorld, settings.grid),
                         camera);
}

struct Spread {
    double mean = 0.0, min = 1e9, max = -1e9;
    int count = 0;
    void add(double value) {
        mean = (mean * count + value) / (count + 1);
        min = std::min(min, value);
        max = std::max(max, value);
        ++count;
    }
};

// Of the red channel over the surfaces.
Spread spreadOf(GatheredFrame& frame, int view) {
    const Image image = frame.view(view);
    const std::vector<SurfacePixel> pixels = frame.pixels();
    Spread spread;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (pixels[i].surface) spread.add(image.pixels[i].x);
    return spread;
}

// Where a preset is not yet what it should be, its bound is what was measured, with a hundredth or so of
// head-room: to be tightened with the gather.
bool isMobile(const char* preset) {
    return std::string(preset) == "mobile";
}

class GatherOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Presets, GatherOf, testing::Values("mobile", "quality"),
                         [](const auto& test) { return std::string(test.param); });

// Without geometry in the voxels nothing shines and nothing occludes: exactly. All of the sky is seen.
TEST_P(GatherOf, AnEmptyVolumeShowsTheSkyAndNothingElse) {
    const Context context = openContext(Backend::egl);
    for (const float sky : {0.0F, 0.75F}) {
        Settings settings = presetAt(GetParam(), {40, 40});
        settings.skyRadiance = glm::vec3(sky);
        GatheredFrame frame =
            frameOf(context, lonePlane(0.0), noLight(), settings, lookAt({0, 3, 0.5}, {0, 0, 0}, 40));
        frame.replaceFaces(FaceLevel(settings.grid));
        const Spread light = spreadOf(frame, VCT_VIEW_INDIRECT), openness = spreadOf(frame, VCT_VIEW_AO);
        ASSERT_GT(light.count, 800);
        EXPECT_NEAR(light.min, sky, sky * std::exp2(-10));  // halves
        EXPECT_NEAR(light.max, sky, sky * std::exp2(-10));
        EXPECT_EQ(openness.min, 1.0);
        EXPECT_EQ(openness.max, 1.0);
    }
}

// Share of the cosine-weighted hemisphere around `n` that a polygon wholly above the horizon fills (Lambert
// 1760).
double formFactor(const std::vector<glm::dvec3>& polygon, const glm::dvec3& p, const glm::dvec3& n) {
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = glm::normalize(polygon[i] - p);
        const glm::dvec3 b = glm::normalize(polygon[(i + 1) % polygon.size()] - p);
        const glm::dvec3 edge = glm::cross(a, b);
        if (glm::length(edge) > 1e-12)
            sum += std::acos(glm::clamp(glm::dot(a, b), -1.0, 1.0)) * glm::dot(glm::normalize(edge), n);
    }
    return std::abs(sum) / (2.0 * pi);
}

// How far a picture is from the truth, of the truth's mean.
struct Error {
    double bias = 0.0, rms = 0.0;
};
template <class Truth>
Error errorOf(GatheredFrame& frame, int view, const Volume& volume, const Truth& truth) {
    const Image image = frame.view(view);
    const std::vector<SurfacePixel> pixels = frame.pixels();
    const glm::dmat4 worldFromVolume = glm::inverse(volume.volumeFromWorld());
    double sum = 0.0, truthSum = 0.0, squares = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].surface) continue;
        const double right = truth(glm::dvec3(worldFromVolume * glm::dvec4(pixels[i].positionVolume, 1.0)));
        if (right < 0.0) continue;
        sum += image.pixels[i].x;
        truthSum += right;
        squares += (image.pixels[i].x - right) * (image.pixels[i].x - right);
        ++count;
    }
    EXPECT_GT(count, 500);
    return {sum / truthSum - 1.0, std::sqrt(squares / count) / (truthSum / count)};
}

struct Emitter {
    const char* name;
    glm::dvec3 corner, u, v;
    Error mobile, quality;  // bounds
};
const Emitter emitters[] = {
    {"ceiling", {-1, 1.0, -1}, {2, 0, 0}, {0, 0, 2}, {0.165, 0.175}, {0.06, 0.065}},
    {"low ceiling", {-1, 0.25, -1}, {2, 0, 0}, {0, 0, 2}, {0.055, 0.07}, {0.125, 0.13}},
    {"lamp", {-0.2, 0.7, -0.2}, {0.4, 0, 0}, {0, 0, 0.4}, {0.115, 0.255}, {0.225, 0.26}},
    {"wall", {-1, 0, -1}, {0, 1, 0}, {0, 0, 2}, {0.175, 0.28}, {0.11, 0.17}}};

// A floor under emitters of radiance 1 whose form factors are known.
TEST_P(GatherOf, AFloorReceivesTheFormFactorOfWhatShines) {
    const Context context = openContext(Backend::egl);
    for (const Emitter& e : emitters)
        for (const double turnDeg : {0.0, 30.0}) {
            Scene scene = emptyScene();
            addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
            addQuad(scene, e.corner, e.u, e.v, addEmitter(scene));
            const glm::dmat4 turn = turnScene(scene, turnDeg);
            scene = finished(std::move(scene));
            const Settings settings = presetAt(GetParam(), glm::ivec2(pictureSide));
            const glm::dvec3 eye(turn * glm::dvec4(0, 3, 0.001, 1));
            GatheredFrame frame = frameOf(context, scene, noLight(), settings, lookAt(eye, {0, 0, 0}, 36));
            const Error error = errorOf(
                frame, VCT_VIEW_INDIRECT, volumeAround(scene.boundsWorld, settings.grid),
                [&](const glm::dvec3& positionWorld) {
                    const glm::dvec3 p(glm::inverse(turn) * glm::dvec4(positionWorld, 1.0));
                    if (std::abs(p.y) > 1e-3) return -1.0;
                    return formFactor({e.corner, e.corner + e.u, e.corner + e.u + e.v, e.corner + e.v}, p,
                                      {0, 1, 0});
                });
            std::printf("%s, %s turned by %g degrees: bias %+.3f, RMS %.3f\n", GetParam(), e.name, turnDeg,
                        error.bias, error.rms);
            const Error& bound = isMobile(GetParam()) ? e.mobile : e.quality;
            EXPECT_LE(std::abs(error.bias), bound.bias) << e.name;
            EXPECT_LE(error.rms, bound.rms) << e.name;
        }
}

// Half of the volume filled and black, under a sky of radiance 1.
TEST_P(GatherOf, AFloorBesideABlackHalfSpaceSeesTheRestOfTheSky) {
    const Context context = openContext(Backend::egl);
    Settings settings = presetAt(GetParam(), glm::ivec2(pictureSide));
    settings.skyRadiance = glm::vec3(1.0F);
    const Scene scene = lonePlane(0.0);
    const Volume volume = volumeAround(scene.boundsWorld, settings.grid);
    GatheredFrame frame = frameOf(context, scene, noLight(), settings, lookAt({0, 3, 0.001}, {0, 0, 0}, 36));
    FaceLevel base(settings.grid);
    const int half = settings.grid / 2;
    base.forEachVoxel([&](const glm::ivec3& voxel) {
        if (voxel.x >= half && voxel.y > half)
            for (int face = 0; face < faceCount; ++face)
                base.at(voxel, face).a = 255;
    });
    frame.replaceFaces(base);
    const double edge = 0.5 * volume.side;  // of the volume, from its centre
    const Error error = errorOf(frame, VCT_VIEW_INDIRECT, volume, [&](const glm::dvec3& p) {
        if (p.x > -1.0 * volume.voxelSize()) return -1.0;
        return 1.0 -
               formFactor({{0, 0, -edge}, {0, edge, -edge}, {0, edge, edge}, {0, 0, edge}}, p, {0, 1, 0});
    });
    std::printf("%s beside a black half-space: bias %+.3f, RMS %.3f\n", GetParam(), error.bias, error.rms);
    EXPECT_LE(std::abs(error.bias), 0.01);
    EXPECT_LE(error.rms, isMobile(GetParam()) ? 0.04 : 0.023);
}

// A closed box whose inside has radiance 1: the right answer is 1 everywhere. The most that the mean lacks is
// 0.07 (mobile, turned).
constexpr double furnaceBar = 0.08;

// As where a lathe's mesh shares vertices between its side and its bottom. Along such a normal a cone would
// start below the floor, in the dark.
TEST_P(GatherOf, AWallsFootIsLitWhereItsNormalsLeanIntoTheFloor) {
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, addEmitter(scene));
    addQuad(scene, {-1, 0, 0}, {2, 0, 0}, {0, 0.5, 0});
    for (const std::size_t bottom : {0U, 1U})
        scene.meshes.back().vertices[bottom].normal = glm::normalize(glm::vec3(0, -1, 1));
    scene = finished(std::move(scene));
    const Settings settings = presetAt(GetParam(), glm::ivec2(pictureSide));
    GatheredFrame frame =
        frameOf(context, scene, noLight(), settings, lookAt({0, 0.2, 1.5}, {0, 0.1, 0}, 20));
    const Image light = frame.view(VCT_VIEW_INDIRECT);
    const std::vector<SurfacePixel> pixels = frame.pixels();
    const glm::dmat4 worldFromVolume =
        glm::inverse(volumeAround(scene.boundsWorld, settings.grid).volumeFromWorld());
    Spread foot;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].surface) continue;
        const glm::dvec3 p(worldFromVolume * glm::dvec4(pixels[i].positionVolume, 1.0));
        if (p.y > 1e-3 && p.y < 0.05) foot.add(light.pixels[i].x);
    }
    ASSERT_GT(foot.count, 500);
    std::printf("%s, foot: mean %.3f, min %.3f\n", GetParam(), foot.mean, foot.min);
    EXPECT_GE(foot.min, 0.6);
}

TEST_P(GatherOf, WhiteFurnaceIsOne) {
    const Context context = openContext(Backend::egl);
    for (const double turnDeg : {0.0, 30.0}) {
        Scene scene = closedBox(turnDeg);
        scene.materials[0].emissive = glm::vec3(1.0F);
        GatheredFrame frame =
            frameOf(context, scene, noLight(), presetAt(GetParam(), glm::ivec2(pictureSide)),
                    lookAt({0, 0, 0}, {0.2, -0.4, -1}, 120));
        const Spread spread = spreadOf(frame, VCT_VIEW_INDIRECT);
        std::printf("%s, furnace turned by %g degrees: mean %.3f, min %.3f, max %.3f (right: 1)\n",
                    GetParam(), turnDeg, spread.mean, spread.min, spread.max);
        EXPECT_NEAR(spread.mean, 1.0, furnaceBar);
        EXPECT_LE(spread.max, 1.02);
        EXPECT_GE(spread.min, isMobile(GetParam()) ? 0.81 : 0.77);
    }
}

// One lit plane in an empty volume: a surface does not light itself, so the right answer is 0.
TEST_P(GatherOf, LoneLitPlaneGetsNothing) {
    const Context context = openContext(Backend::egl);
    for (const double turnDeg : {0.0, 30.0, 45.0}) {
        const Scene scene = lonePlane(turnDeg);
        const glm::dvec3 up(scene.instances[0].worldFromObject * glm::dvec4(0, 1, 0, 0));
        GatheredFrame frame =
            frameOf(context, scene, lightFrom(up), presetAt(GetParam(), glm::ivec2(pictureSide)),
                    lookAt(3.0 * up + glm::dvec3(0.3, 0, 0), {0, 0, 0}, 40));
        const Spread light = spreadOf(frame, VCT_VIEW_INDIRECT), openness = spreadOf(frame, VCT_VIEW_AO);
        std::printf("%s, lone plane turned by %g degrees: mean %.4f, max %.4f; openness from %.4f\n",
                    GetParam(), turnDeg, light.mean, light.max, openness.min);
        ASSERT_GT(light.count, 1000);
        EXPECT_LE(light.mean, 1e-4);
        EXPECT_LE(light.max, 1e-3);
        EXPECT_GE(light.min, 0.0);
        EXPECT_GE(openness.min, 0.999);
    }
}

// A room halved by a wall of a third of a voxel, one half of which shines: nothing of it arrives in the
// other.
TEST_P(GatherOf, LightStaysOnItsSideOfAThinWall) {
    const Context context = openContext(Backend::egl);
    for (const double turnDeg : {0.0, 30.0}) {
        Scene scene = emptyScene();
        const glm::dvec3 x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
        addQuad(scene, {-1, -1, -1}, z, x);
        addQuad(scene, {-1, 1, -1}, x, z);
        addQuad(scene, {-1, -1, -1}, y, z, addEmitter(scene));
        addQuad(scene, {1, -1, -1}, z, y);
        addQuad(scene, {-1, -1, -1}, x, y);
        addQuad(scene, {-1, -1, 1}, y, x);
        addQuad(scene, {-0.005, -1, -1}, z, y);  // facing the light
        addQuad(scene, {0.005, -1, -1}, y, z);
        const glm::dmat4 turn = turnScene(scene, turnDeg);
        scene = finished(std::move(scene));
        const Settings settings = presetAt(GetParam(), glm::ivec2(pictureSide));
        GatheredFrame frame = frameOf(context, scene, noLight(), settings,
                                      lookAt(glm::dvec3(turn * glm::dvec4(0, 0, 4, 1)), {0, 0, 0}, 40));
        const Image image = frame.view(VCT_VIEW_INDIRECT);
        const std::vector<SurfacePixel> pixels = frame.pixels();
        const glm::dmat4 boxFromVolume =
            glm::inverse(volumeAround(scene.boundsWorld, settings.grid).volumeFromWorld() * turn);
        Spread lit, dark;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (!pixels[i].surface) continue;
            const double px = (boxFromVolume * glm::dvec4(pixels[i].positionVolume, 1.0)).x;
            if (std::abs(px) > 0.02) (px < 0.0 ? lit : dark).add(image.pixels[i].x);
        }
        std::printf("%s, wall turned by %g: lit half %.3f, dark half mean %.4f, max %.4f\n", GetParam(),
                    turnDeg, lit.mean, dark.mean, dark.max);
        ASSERT_GT(lit.mean, 0.15);
        ASSERT_GT(dark.count, 1000);
        // What there is comes from around the wall's edges, where coarse voxels reach past it.
        EXPECT_LE(dark.mean, 0.055 * lit.mean);
        EXPECT_LE(dark.max, isMobile(GetParam()) ? 0.15 : 0.125);
    }
}

double meanOf(const Image& image) {
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels)
        sum += pixel.x;
    return sum / static_cast<double>(image.pixels.size());
}

// Light of any strength, from wherever: the picture is as many times brighter, bounces included.
TEST(FaceRadiance, ARoomUnderTheSkyAloneHasBouncesInProportion) {
    const Context context = openContext(Backend::egl);
    Scene scene = closedBox(0.0);
    scene.instances.erase(scene.instances.begin() + 1);  // the ceiling
    const auto lit = [&](float sky, int bounces) {
        Settings settings = presetAt("mobile", {48, 48});
        settings.skyRadiance = glm::vec3(sky);
        settings.bounces = bounces;
        Renderer renderer = makeRenderer(context, scene, noLight(), settings);
        renderer.frame(Mode::gi, lookAt({0, 0, 0.9}, {0, -0.5, 0}, 60));
        return meanOf(renderer.radiance());
    };
    const double first = lit(1.0F, 0), all = lit(1.0F, 4);
    std::printf("sky of 1: %.3f, with bounces %.3f; sky of 10: %.3f\n", first, all, lit(10.0F, 4));
    EXPECT_NEAR(lit(10.0F, 0), 10.0 * first, 0.01 * first);
    EXPECT_GT(all, 1.3 * first);
    EXPECT_NEAR(lit(10.0F, 4), 10.0 * all, 0.3 * all);
}

// A closed white box, a thousandth of which shines. As much light comes out as the emitter's power over what
// the walls absorb of it: with the direct light D of all walls, bounces bring D albedo / (1 - albedo) in all.
class BoxOfAlbedo {
  public:
    BoxOfAlbedo(const Context& context, const char* preset, float albedo, int grid = 0)
        : context_(context), scene_(closedBox(0.0)), settings_(presetAt(preset, {64, 64})) {
        if (grid > 0) settings_.grid = grid;
        scene_.materials[0].baseColor = glm::vec4(glm::vec3(albedo), 1.0F);
        scene_.materials.push_back(scene_.materials[0]);
        scene_.materials[1].emissive = glm::vec3(1.0F);
        addQuad(scene_, {-0.25, 0.98, -0.25}, {0.5, 0, 0}, {0, 0, 0.5}, 1);
        scene_ = finished(std::move(scene_));
    }

    // Mean over a picture that does not show the emitter.
    double withBounces(int bounces) const {
        Settings settings = settings_;
        settings.bounces = bounces;
        Renderer renderer = makeRenderer(context_, scene_, noLight(), settings);
        renderer.frame(Mode::gi, lookAt({0, 0.5, 0.9}, {0, -0.6, -0.4}, 70));
        for (const glm::vec3& pixel : renderer.radiance().pixels)
            EXPECT_TRUE(std::isfinite(pixel.x) && pixel.x >= 0.0F) << bounces << " bounces";
        return meanOf(renderer.radiance());
    }

  private:
    const Context& context_;
    Scene scene_;
    Settings settings_;
};

TEST_P(GatherOf, BouncesInAClosedBoxConvergeFromBelow) {
    const Context context = openContext(Backend::egl);
    for (const float albedo : {0.5F, 0.8F, 0.9F}) {
        const BoxOfAlbedo box(context, GetParam(), albedo);
        const double first = box.withBounces(0);
        // The first of them is in the picture without bounces.
        const double right = 1.0 / (1.0 - static_cast<double>(albedo));
        std::printf("%s, albedo %.1f, of what is right (%.1f):", GetParam(), albedo, right);
        double share = 0.0, before = 0.0;
        for (const int bounces : {1, 2, 4, 8, 16, 32}) {
            before = share;
            share = box.withBounces(bounces) / first / right;
            std::printf(" %d: %.3f", bounces, share);
            EXPECT_LE(share, 1.0) << albedo << ", " << bounces << " bounces";
        }
        std::printf("\n");
        EXPECT_NEAR(share, before, 0.1 * share) << albedo;
    }
}

TEST_P(GatherOf, BouncesThatNothingAbsorbsGrowNoFasterThanLinearly) {
    const Context context = openContext(Backend::egl);
    const BoxOfAlbedo box(context, GetParam(), 1.0F);
    const double first = box.withBounces(0);
    std::printf("%s, albedo 1, over one bounce:", GetParam());
    // From two on, the estimate of the rest adds at most 0.95 / (1 - 0.95) times the last.
    for (const int bounces : {1, 2, 4, 8, 16, 32, 64}) {
        const double times = box.withBounces(bounces) / first;
        std::printf(" %d: %.2f", bounces, times);
        EXPECT_LE(times, 1.05 * (1.0 + bounces + (bounces > 1 ? 19.0 : 0.0)));
    }
    std::printf("\n");
}

}  // namespace
}  // namespace vct::test
