// A renderer that goes from pose to pose equals a fresh one of a static scene in that pose.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/volume.h"
#include "support/face_irradiance.h"
#include "support/gl_spy.h"
#include "support/grids.h"
#include "support/playing_scene.h"
#include "support/punctual_light.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

class Moving : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Voxels, Moving, everyVoxelKind(), nameOfPreset);

TEST_P(Moving, EveryFrameIsThatOfAFreshRendererOfItsPose) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatMove());
    ASSERT_EQ(std::count_if(scene.instances.begin(), scene.instances.end(),
                            [](const Instance& instance) { return instance.moves(); }),
              2);
    const Settings settings = smallPreset(GetParam());
    for (const Output mode : {Output::gi, Output::ao}) {
        PlayingScene stage(context, scene, settings);
        for (const double seconds : {0.0, 0.35, 1.0, 1.7, 2.0, 0.35})
            expectFresh(stage, context, scene, settings, seconds, mode);
        // The scene goes back to rest.
        const Grid moved = gridOf(stage.renderer());
        stage.frameAt(0.0, mode);
        EXPECT_FALSE(gridOf(stage.renderer()).lists == moved.lists) << "nothing moves";
    }
}

// Occlusion needs voxels without irradiance, and phong needs none.
TEST_P(Moving, EveryFrameIsFreshWhenModesTakeTurns) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatMove());
    const Settings settings = smallPreset(GetParam());
    PlayingScene stage(context, scene, settings);
    stage.frameAt(0.1);
    expectFresh(stage, context, scene, settings, 0.4, Output::ao);
    expectFresh(stage, context, scene, settings, 0.7, Output::ao);
    expectFresh(stage, context, scene, settings, 0.9);
    stage.frameAt(1.2, Output::phong);
    expectFresh(stage, context, scene, settings, 1.5);
    expectFresh(stage, context, scene, settings, 1.5, Output::ao);
}

// The box is inside for one second, far outside for one, and inside again.
TEST_P(Moving, ABoxMayLeaveTheVolumeAndComeBack) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    const int bird = addCube(builder, {0.2F, 0.2F, 0.9F}, {{"translation", {0, 1, 0}}});
    builder.animate(bird, "translation", {0, 1, 2, 3}, {0, 1, 0, 0, 1, 0, 900, 300, -40, 0.4F, 1.1F, 0});
    const Scene scene = load(builder);
    EXPECT_LT(scene.boundsWorld.max.x, 4.1) << "half of the floor's 4 m beyond its edge";
    const Settings settings = smallPreset(GetParam());
    PlayingScene stage(context, scene, settings);
    stage.frameAt(0.0);
    const std::size_t inside = gridOf(stage.renderer()).lists[0].size();
    expectFresh(stage, context, scene, settings, 2.0);
    const std::size_t away = gridOf(stage.renderer()).lists[0].size();
    EXPECT_LT(away + 50, inside);
    expectFresh(stage, context, scene, settings, 1.01);  // partly outside
    expectFresh(stage, context, scene, settings, 3.0);
    EXPECT_GT(gridOf(stage.renderer()).lists[0].size(), away + 50);
}

// Without a static face, the pose in which nothing is visible has no face at all. The pose before it is
// removed in any case.
TEST(MovingInstances, ABoxMayVanishFromAnEmptySpaceAndComeBack) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder;
    const int box = addCube(builder, {0.9F, 0.6F, 0.1F}, {});
    builder.animate(box, "scale", {0, 1, 2}, {1, 1, 1, 0, 0, 0, 1, 1, 1});
    const Scene scene = load(builder);
    PlayingScene stage(context, scene, mobileSettings());
    stage.frameAt(0.0);
    ASSERT_GT(gridOf(stage.renderer()).lists[0].size(), 1000U);
    stage.frameAt(1.0);
    EXPECT_EQ(gridOf(stage.renderer()).lists[0].size(), 0U);
    expectFresh(stage, context, scene, mobileSettings(), 2.0);
}

// The box needs far more voxels than the first frame had capacity for.
TEST(MovingInstances, ABoxMayGrowFromNothing) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    const int box = addCube(builder, {0.9F, 0.6F, 0.1F}, {{"translation", {0, 1, 0}}, {"scale", {0, 0, 0}}});
    builder.animate(box, "scale", {0, 1, 2}, {0, 0, 0, 3, 1.8F, 3, 0, 0, 0});
    const Scene scene = load(builder);
    const Settings settings = mobileSettings();
    PlayingScene stage(context, scene, settings);
    stage.frame();  // the box is nothing at rest
    for (const double seconds : {0.0, 0.3, 1.0, 2.0, 0.9})
        expectFresh(stage, context, scene, settings, seconds);
}

// Until it is asked for the second time, the GPU has not reached a fence.
class GpuOneFrameBehind {
  public:
    GpuOneFrameBehind() : driver_(std::exchange(gl::ClientWaitSync, call)) { current = this; }
    ~GpuOneFrameBehind() { gl::ClientWaitSync = driver_; }

  private:
    static GLenum GL_APIENTRY call(GLsync fence, GLbitfield flags, GLuint64 timeout) {
        const bool isFirst = std::exchange(current->last_, fence) != fence;
        return isFirst ? GL_TIMEOUT_EXPIRED : current->driver_(fence, flags, timeout);
    }
    static inline GpuOneFrameBehind* current = nullptr;
    decltype(gl::ClientWaitSync) driver_;
    GLsync last_ = nullptr;
    const GlSpy<&gl::FenceSync> made_{[this](GLenum, GLbitfield) { last_ = nullptr; }};  // may be reused
};

TEST(MovingInstances, ABoxMayGrowWhileTheGpuIsAFrameBehind) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    const int box = addCube(builder, {0.9F, 0.6F, 0.1F}, {{"translation", {0, 1, 0}}, {"scale", {0, 0, 0}}});
    builder.animate(box, "scale", {0, 1, 2}, {0, 0, 0, 3, 1.8F, 3, 3.1F, 1.9F, 3.1F});
    const Scene scene = load(builder);
    PlayingScene stage(context, scene, mobileSettings());
    const GpuOneFrameBehind delay;
    for (int frame = 0; frame < 12; ++frame)
        stage.frameAt(0.2 * frame);
    const DirectionalVoxels& voxels = stage.renderer().directional()->voxels();
    const std::uint32_t list = voxels.dynamicList(),
                        faces = voxels.index().readCommands().lists[list].faceCount;
    EXPECT_GT(faces, 1000U);
    EXPECT_LE(faces, voxels.capacities()[list]);
}

// The bricks of an upright box are flat, those of a tilted one are not. A brick without a place would take
// its light from elsewhere, and which one that is would depend on the order of threads.
TEST(MovingInstances, ABoxThatTurnsHasRoomForItsFacesAndBricks) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    const int box =
        addCube(builder, {0.9F, 0.6F, 0.1F}, {{"translation", {0, 1.2, 0}}, {"scale", {1.5, 1.5, 1.5}}});
    builder.animate(box, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0.1736F, 0, 0.9848F});
    const Scene scene = load(builder);
    PlayingScene stage(context, scene, mobileSettings());
    stage.frameAt(0.0);
    stage.frameAt(1.0);
    const DirectionalVolume& volume = *stage.renderer().directional();
    constexpr std::size_t texels = VCT_BRICK_TEXELS, bytesOfTexel = 8;
    const std::size_t room =
        volume.irradiance()->textures().at(0)->bytes() / (texels * texels * bytesOfTexel);
    const shared::CommandLists found = volume.voxels().index().readCommands();
    EXPECT_GT(found.brickLayers[0], 600U);
    EXPECT_LE(found.brickLayers[0], room);
    for (const std::uint32_t list : {found.dynamicList, std::uint32_t{VCT_BRICK_LEVEL}})
        EXPECT_LE(found.lists[list].faceCount, found.lists[list].faceCapacity) << "list " << list;
}

// A picture of converged light has no frame after it that could add room.
TEST(MovingInstances, ABoxFillsAConvergedPictureAtOnce) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    const int box = addCube(builder, {0.9F, 0.6F, 0.1F}, {{"translation", {0, 1, 0}}, {"scale", {0, 0, 0}}});
    builder.animate(box, "scale", {0, 1}, {0, 0, 0, 3, 1.8F, 3});
    const Scene scene = load(builder);
    PlayingScene stage(context, scene, mobileSettings());
    stage.convergedAt(0.0);
    expectFreshLight(stage, context, scene, mobileSettings(), 1.0);
}

// Each of many small objects hides little of what a surface receives, but all of them together hide much.
TEST(MovingInstances, ManySmallOnesBlockAsMuchLightAsStaticOnes) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    addCube(builder, {0.7F, 0.7F, 0.7F}, {{"translation", {0, 1.6, 0}}, {"scale", {2, 0.2, 2}}});
    for (int i = 0; i < 64; ++i) {
        const float x = -1.4F + 0.4F * static_cast<float>(i % 8),
                    z = -1.4F + 0.4F * static_cast<float>(i / 8);
        const int cube = addCube(builder, {0.1F, 0.1F, 0.1F},
                                 {{"translation", {x, 0.1F, z}}, {"scale", {0.13, 0.13, 0.13}}});
        builder.animate(cube, "translation", {0, 1}, {x, 0.1F, z, x, 0.101F, z});
    }
    const Scene scene = load(builder), frozen = frozenAt(scene, 0.0);
    Settings settings = mobileSettings();
    settings.lightFrames = 8;  // without the refinement, which finds all objects
    PlayingScene moving(context, scene, settings), still(context, frozen, settings);
    moving.convergedAt(0.0);
    still.convergedAt(0.0);
    const IrradianceDifference d =
        differenceOf(readIrradiance(moving.renderer()), readIrradiance(still.renderer()));
    EXPECT_GT(d.common, 2000U);
    EXPECT_LE(std::abs(d.bias), 0.015 * d.mean);
    EXPECT_LE(d.rms, 0.07 * d.mean);
}

// Objects block more rays than the first step has room for. If it left some out, their light would depend on
// the order of threads.
TEST(MovingInstances, BlockAllTheirRaysInTheFirstStepOfAPicture) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("moving.glb"));
    Settings settings = smallPreset("quality");
    settings.lightFrames = 2;
    PlayingScene stage(context, scene, settings);
    stage.convergedAt(0.0);
    const DirectionalVolume& volume = *stage.renderer().directional();
    const std::uint32_t blocked = volume.voxels().index().readCommands().mostBlockedRays;
    EXPECT_GT(blocked, 1U << 18U);
    EXPECT_LE(blocked, volume.irradiance()->blockedCapacity());
    const IrradianceByFace first = readIrradiance(stage.renderer());
    // Light starts again, now with room for as many rays as were counted.
    stage.renderer().render(
        {{Output::gi}, chooseCamera(scene, ""), LightSteps::all, nullptr, /*allBounces=*/false});
    stage.convergedAt(0.0);
    const IrradianceDifference d = differenceOf(first, readIrradiance(stage.renderer()));
    EXPECT_GT(d.common, 10000U);
    EXPECT_LE(d.largest, 0.001 * d.mean);
}

TEST_P(Moving, TheLightMaySetAndTheCameraMayMove) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    addCube(builder, {0.8F, 0.3F, 0.1F}, {{"translation", {0, 0.5, 0}}});
    // The sun turns about +X from 60 degrees above the horizon to as much below.
    builder.animate(1, "rotation", {0, 1, 2}, {-0.5F, 0, 0, 0.8660254F, 0, 0, 0, 1, 0.5F, 0, 0, 0.8660254F});
    builder.animate(2, "translation", {0, 2}, {0, 2.6F, 5.2F, 1.5F, 2.2F, 4.4F});
    const Scene scene = load(builder);
    const Settings settings = smallPreset(GetParam());
    PlayingScene stage(context, scene, settings);
    const auto brightness = [&] {
        double sum = 0.0;
        for (const glm::vec3& p : stage.renderer().radiance().pixels) {
            EXPECT_TRUE(std::isfinite(p.r + p.g + p.b));
            sum += p.g;
        }
        return sum;
    };
    stage.convergedAt(0.0);
    const double day = brightness();
    for (const double seconds : {0.9, 1.0, 2.0, 0.5})
        expectFresh(stage, context, scene, settings, seconds);
    stage.convergedAt(2.0);
    // The light from below reaches the underside of the floor alone, which the camera does not see.
    EXPECT_LT(brightness(), 0.05 * day);
}

// The box shares voxels with the wall and shades it. The wall covers its voxels in part, so anything that is
// added twice would show.
TEST(MovingInstances, ABoxMayPassThroughAWall) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    addCube(builder, {0.7F, 0.7F, 0.2F},
            {{"translation", {0, 0.8, 0}}, {"rotation", {0.05, 0.1, 0.08, 0.99}}, {"scale", {0.1, 1.6, 3}}});
    const int box =
        addCube(builder, {0.1F, 0.3F, 0.9F}, {{"translation", {-1, 0.7, 0}}, {"scale", {0.4, 0.4, 0.4}}});
    builder.animate(box, "translation", {0, 2}, {-1, 0.7F, -0.3F, 1, 0.9F, 0.3F});
    const Scene scene = load(builder);
    const Settings settings = mobileSettings();
    PlayingScene stage(context, scene, settings);
    for (double seconds = 0.0; seconds <= 2.0; seconds += 0.4)
        expectFresh(stage, context, scene, settings, seconds);
}

// The box jumps from one map of the point light to another, and from tile to tile of the sun's map.
TEST(MovingInstances, TakeTheirShadowsAlong) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    const int box =
        addCube(builder, {0.2F, 0.2F, 0.9F}, {{"translation", {0, 0.3, 1.5}}, {"scale", {0.3, 0.6, 0.3}}});
    builder.animate(box, "translation", {0, 1, 2, 3, 4},
                    {0, 0.3F, 1.5F, -1.6F, 0.3F, -1.6F, 1.6F, 0.3F, -1.6F, 1.2F, 1.6F, 1.2F, 0, 0.3F, 1.5F});
    Scene scene = load(builder);
    scene.punctualLights = {punctualLightAt(PunctualLight::Type::point, {0, 1, 0}, {0, 0, 0})};
    for (const int cascades : {1, 3}) {
        Settings settings = mobileAt(96);
        settings.cascades = cascades;
        PlayingScene stage(context, scene, settings);
        for (const double seconds : {0.0, 1.0, 3.0})
            expectFresh(stage, context, scene, settings, seconds, Output::ao);
    }
}

// The bird flies ten times as far away as the scene is wide, where no volume reaches.
TEST(MovingInstances, AreSeenBeyondTheVolume) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    const int bird = addCube(builder, {0.9F, 0.1F, 0.1F}, {{"translation", {0, 1, 0}}});
    builder.animate(bird, "translation", {0, 1}, {0, 1, 0, 0, 0, -40});
    builder.animate(bird, "scale", {0, 1}, {1, 1, 1, 6, 6, 6});
    const Scene scene = load(builder);
    PlayingScene stage(context, scene, mobileSettings());
    const auto redPixels = [&](double seconds) {
        stage.frameAt(seconds);
        const std::vector<glm::vec3>& pixels = stage.renderer().radiance().pixels;
        return std::count_if(pixels.begin(), pixels.end(),
                             [](const glm::vec3& p) { return p.r > 0.05F && p.r > 3.0F * p.g; });
    };
    EXPECT_GT(redPixels(0.0), 20);
    EXPECT_GT(redPixels(1.0), 10);
}

class Deforming : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Voxels, Deforming, everyVoxelKind(), nameOfPreset);

TEST_P(Deforming, EveryFrameIsThatOfAFreshRendererOfItsPose) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatDeform());
    ASSERT_EQ(std::count_if(scene.instances.begin(), scene.instances.end(),
                            [](const Instance& instance) { return instance.deforms; }),
              2);
    const Settings settings = smallPreset(GetParam());
    for (const Output mode : {Output::gi, Output::ao}) {
        PlayingScene stage(context, scene, settings);
        for (const double seconds : {0.0, 0.35, 1.0, 1.7, 2.0, 0.35}) {
            stage.drawTwiceAt(seconds, mode);
            PlayingScene fresh(context, scene, settings);
            fresh.drawTwiceAt(seconds, mode);
            expectSameGrid(gridOf(stage.renderer()), gridOf(fresh.renderer()), std::to_string(seconds));
        }
        const Grid before = gridOf(stage.renderer());
        stage.frameAt(1.7, mode);
        EXPECT_FALSE(gridOf(stage.renderer()).lists == before.lists) << "nothing changes its form";
    }
}

// The GPU computes in float and the CPU in double, so an edge may fall on another pixel.
TEST_P(Deforming, EqualsTheDeformationOfTheCpu) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatDeform());
    Settings settings = smallPreset(GetParam());
    settings.size = glm::ivec2(128);
    for (const double seconds : {0.0, 0.6, 1.3, 2.0}) {
        PlayingScene stage(context, scene, settings);
        stage.frameAt(seconds, Output::phong);
        const Scene frozen = frozenAt(scene, seconds);
        PlayingScene expected(context, frozen, settings);
        expected.frame(Output::phong);
        PlayingScene rest(context, scene, settings);
        rest.frame(Output::phong);
        const auto differing = [&](Renderer& a, Renderer& b) {
            const Image x = a.radiance(), y = b.radiance();
            int count = 0;
            for (std::size_t i = 0; i < x.pixels.size(); ++i)
                count += glm::length(x.pixels[i] - y.pixels[i]) > 0.02F ? 1 : 0;
            return count;
        };
        EXPECT_LE(differing(stage.renderer(), expected.renderer()), 16) << seconds << " of 16384 pixels";
        if (seconds > 0.0) {
            EXPECT_GT(differing(stage.renderer(), rest.renderer()), 400) << seconds;
        }
    }
}

// Light is refined while a box stands on the floor. Once the box has left, nothing of it is seen there.
TEST(MovingInstances, LeaveNoTraceOfTheRefinementBelowThem) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    addCube(builder, {0.7F, 0.7F, 0.7F}, {{"translation", {0, 1, -1.4}}, {"scale", {3, 2, 0.2}}});
    const int box =
        addCube(builder, {0.7F, 0.03F, 0.03F}, {{"translation", {0, 0.4, -0.6}}, {"scale", {0.8, 0.8, 0.8}}});
    builder.animate(box, "translation", {0, 1}, {0, 0.4F, -0.6F, 0, 0.4F, 1.2F});
    const Scene scene = load(builder);
    Settings settings = mobileSettings();
    settings.lightFrames = 16;
    settings.gather.refinedDirections = 256;
    PlayingScene left(context, scene, settings), fresh(context, scene, settings);
    left.convergedAt(0.0);
    for (int frame = 1; frame <= 8; ++frame)
        left.frameAt(1.0 - 1e-4 * (8 - frame));
    fresh.convergedAt(1.0);
    const IrradianceDifference d =
        differenceOf(readIrradiance(left.renderer()), readIrradiance(fresh.renderer()));
    EXPECT_GT(d.common, 5000U);
    EXPECT_LE(d.rms, 0.05 * d.mean);
}

// A door shares voxels, and so faces, with the wall beside it. Rays of the static geometry that are traced
// while the door is closed end at the wall alone.
TEST(MovingInstances, LeaveADoorwayOpenToRaysThatAreKept) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    for (const double x : {-1.13, 1.13})
        addCube(builder, {0.7F, 0.7F, 0.7F}, {{"translation", {x, 1, 0}}, {"scale", {1.6, 2, 0.2}}});
    const int door =
        addCube(builder, {0.5F, 0.3F, 0.2F}, {{"translation", {0, 1, 0}}, {"scale", {0.66, 2, 0.16}}});
    builder.animate(door, "translation", {0, 1}, {0, 1, 0, 0, 1, -1.9F});
    const Scene scene = load(builder);
    PlayingScene opened(context, scene, mobileSettings()), open(context, scene, mobileSettings());
    opened.convergedAt(0.0);
    opened.convergedAt(1.0);
    open.convergedAt(1.0);
    const IrradianceDifference d =
        differenceOf(readIrradiance(opened.renderer()), readIrradiance(open.renderer()));
    EXPECT_GT(d.common, 5000U);
    EXPECT_LE(d.rms, 0.002 * d.mean);
    EXPECT_LE(d.largest, 0.05 * d.mean);
}

}  // namespace
}  // namespace vct::test
