// The look-up of irradiance by pixels, in bricks with filtering.
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

// A sloping plane under an emitting ceiling passes through many bricks. From pixel to pixel the light changes
// no more between two bricks than between voxels of one.
TEST(IrradianceLookUp, HasNoSeamsBetweenBricks) {
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    Settings settings = mobileAt(256);
    settings.grid = 64;
    addQuad(scene, {6, 12, 6}, {0, 3, 50}, {50, 9, 0});
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].emissive = glm::vec3(1.0F);
    addQuad(scene, {6, 58, 6}, {50, 0, 0}, {0, 0, 50}, 1);
    scene.boundsWorld = boundsForVoxelsAsWorld(64);
    FrameInspector frame(context, scene, noLight(), settings, lookAt({31, 50, 31.01}, {31, 16, 31}, 60));
    const Image image = frame.view(Output::indirectLight);
    const std::vector<SurfacePixel>& pixels = frame.pixels();
    struct Jumps {
        double sum = 0.0, largest = 0.0;
        int count = 0;
    } across, within;
    const auto voxelOf = [&](std::size_t i) { return glm::ivec3(pixels[i].positionVolume * 64.0); };
    for (std::size_t i = 0; i + 1 < pixels.size(); ++i) {
        if (static_cast<int>(i + 1) % image.width == 0 || !pixels[i].surface || !pixels[i + 1].surface)
            continue;
        const glm::ivec3 here = voxelOf(i), next = voxelOf(i + 1);
        if (here == next) continue;
        Jumps& jumps = here / 4 == next / 4 ? within : across;
        const double jump = std::abs(image.pixels[i].x - image.pixels[i + 1].x);
        jumps.sum += jump;
        jumps.largest = std::max(jumps.largest, jump);
        ++jumps.count;
    }
    ASSERT_GT(across.count, 2000);
    // .0023 and .0019: within a brick the light of narrow cones changes that little.
    EXPECT_LE(across.sum / across.count, 1.3 * within.sum / within.count);
    // Steps are a few of a half's last bits. A seam would be ten times as large.
    EXPECT_LE(across.largest, 2.0 * within.largest);
    EXPECT_GT(within.sum, 0.0);
}

// A thin wall meets a ceiling, straight and turned. Along the wall the light of the ceiling changes smoothly,
// although pixels beside the wall take texels that begin at a voxel of their own side.
TEST(IrradianceLookUp, HasNoTeethAlongAThinWall) {
    const Context context = openContext(Backend::egl);
    const double voxel = 2.0 / 60.0, thickness = 0.74 * voxel;
    for (const double angleDeg : {0.0, 35.0}) {
        Scene scene = closedBox(0.0);
        addBox(scene, {thickness, 2, 2});
        scene.materials.push_back(scene.materials[0]);
        scene.materials[1].emissive = glm::vec3(1.0F);
        addQuad(scene, {0.99, -0.5, -0.5}, {0, 0, 1}, {0, 1, 0}, 1);
        const glm::dmat4 turn = turnScene(scene, angleDeg, {0, 1, 0});
        const auto turned = [&](const glm::dvec3& p) { return glm::dvec3(turn * glm::dvec4(p, 1.0)); };
        FrameInspector frame(context, finished(std::move(scene)), noLight(), mobileAt(256),
                             lookAt(turned({0.35, 0.4, 0.02}), turned({0.05, 1, 0}), 70));
        const Image image = frame.view(Output::irradiance);
        const std::vector<SurfacePixel>& pixels = frame.pixels();
        const auto isNearWall = [&](std::size_t i) {
            const glm::dvec3 at(glm::inverse(turn) * glm::dvec4(pixels[i].positionWorld, 1.0));
            const double fromWall = (at.x - 0.5 * thickness) / voxel;
            return pixels[i].surface && pixels[i].normal.y < -0.9 && fromWall > 0.1 && fromWall < 2.0 &&
                   std::abs(at.z) < 0.8;
        };
        int count = 0;
        double largest = 0.0;
        for (std::size_t i = 0; i + static_cast<std::size_t>(image.width) < pixels.size(); ++i)
            for (const std::size_t next : {i + 1, i + static_cast<std::size_t>(image.width)}) {
                if (!isNearWall(i) || !isNearWall(next)) continue;
                const float a = image.pixels[i].x, b = image.pixels[next].x;
                largest = std::max(largest, std::abs(a - b) / std::max<double>(std::min(a, b), 1e-6));
                ++count;
            }
        ASSERT_GT(count, 2000);
        EXPECT_LE(largest, 0.006) << angleDeg;
    }
}

// An inner wall ends at the back of a front wall of less than a voxel. In front, the light has no step there.
TEST(IrradianceLookUp, AWallBehindASurfaceDoesNotDivideIt) {
    const Context context = openContext(Backend::egl);
    const double voxel = 2.0 / 60.0, thickness = 0.6 * voxel;
    for (const double shift : {0.0, 0.6}) {
        Scene scene = closedBox(0.0);
        const double front = (0.2 + shift) * voxel;
        addBox(scene, {2, 2, thickness}, {0, 0, front - 0.5 * thickness});
        addBox(scene, {thickness, 2, 0.9}, {0, 0, front - thickness - 0.45});
        scene.materials.push_back(scene.materials[0]);
        scene.materials[1].emissive = glm::vec3(1.0F);
        addQuad(scene, {0.2, -0.5, 0.3}, {0, 1, 0}, {0.3, 0, 0}, 1);
        FrameInspector frame(context, finished(std::move(scene)), noLight(), mobileAt(256),
                             lookAt({-0.2, 0, 0.4}, {0, 0, 0}, 60));
        const Image image = frame.view(Output::irradiance);
        const std::vector<SurfacePixel>& pixels = frame.pixels();
        int steps = 0, count = 0;
        for (std::size_t i = 0; i + 1 < pixels.size(); ++i) {
            const double x = pixels[i].positionWorld.x, next = pixels[i + 1].positionWorld.x;
            if (!pixels[i].surface || !pixels[i + 1].surface || pixels[i].normal.z < 0.9F ||
                std::abs(x) > 3.0 * voxel || std::abs(x - next) > voxel)
                continue;
            const double a = image.pixels[i].x, b = image.pixels[i + 1].x;
            steps += std::abs(a - b) > 0.05 * std::min(a, b);
            ++count;
        }
        ASSERT_GT(count, 2000);
        EXPECT_LE(steps, count / 500) << shift;
    }
}

// Rounding decides which of two voxels, and so bricks, holds a fragment.
TEST(IrradianceLookUp, FindsAPlaneOnTheBorderOfBlocks) {
    const Context context = openContext(Backend::egl);
    Settings settings = mobileAt(64);
    settings.skyRadiance = glm::vec3(1.0F);
    for (int axis = 0; axis < 3; ++axis)
        for (const double at : {32.0, 12.0 + 1e-5}) {
            const double side = at == 32.0 ? 1.0 : -1.0;
            glm::dvec3 corner(8.3), u(0.0), v(0.0), normal(0.0);
            corner[axis] = at;
            normal[axis] = side;
            u[(axis + 1) % 3] = 48.0;
            v[(axis + 2) % 3] = 48.0;
            if (side < 0.0) std::swap(u, v);
            Scene scene = emptyScene();
            addQuad(scene, corner, u, v);
            scene.boundsWorld = boundsForVoxelsAsWorld(64);
            const glm::dvec3 centre = corner + 0.5 * (u + v);
            FrameInspector frame(context, scene, noLight(), settings,
                                 lookAt(centre + 30.0 * normal + glm::dvec3(1, 2, 3), centre, 60));
            for (const Output view : {Output::indirectLight, Output::ambientVisibility}) {
                const Spread spread = frame.spreadOf(view);
                ASSERT_GT(spread.count, 2000);
                EXPECT_GE(spread.min, 0.97)
                    << "axis " << axis << ", side " << side << ", at " << at << ", " << outputName(view);
            }
        }
}

// The rods of a grille are thinner than a voxel, so some pixels have no face on their normal's side.
TEST(IrradianceLookUp, ThinRodsBeforeTheSkyAreLit) {
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    for (int i = 0; i < 9; ++i) {
        const double at = -0.97 + 0.231 * i;
        addQuad(scene, {at, -1, 0}, {0.018, 0, 0}, {0.3, 2, 0});
        addQuad(scene, {-1, at, 0.001}, {2, 0.2, 0}, {0, 0.018, 0});
    }
    scene = finished(std::move(scene));
    Settings settings = mobileAt(260);
    settings.skyRadiance = glm::vec3(1.0F);
    FrameInspector frame(context, scene, noLight(), settings, lookAt({0, 0, 4}, {0, 0, 0}, 40));
    const Image light = frame.view(Output::indirectLight),
                ambientVisibility = frame.view(Output::ambientVisibility);
    const std::vector<SurfacePixel>& pixels = frame.pixels();
    int surfaces = 0, dark = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].surface) continue;
        ++surfaces;
        dark += light.pixels[i].x < 0.9F || ambientVisibility.pixels[i].x < 0.9F ? 1 : 0;
    }
    ASSERT_GT(surfaces, 4000);
    EXPECT_EQ(dark, 0) << "of " << surfaces;
}

// A floor ends where a wall begins. The stored position of the wall is rounded, here onto the floor, whose
// pixels there must not take the light of the wall's other side.
TEST(IrradianceLookUp, AFloorThatEndsAtAWallHasItsOwnLight) {
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    const auto addSlab = [&scene](const glm::dvec3& from, const glm::dvec3& to) {
        addBox(scene, to - from, 0.5 * (from + to));
    };
    const double wall = 19.467, floor = 12.3;
    addSlab({wall, floor - 2.0, 4.0}, {60.0, floor, 60.0});
    addSlab({16.0, floor - 2.0, 4.0}, {wall, 15.0, 60.0});
    addSlab({16.0, 15.0, 4.0}, {60.0, 17.0, 60.0});
    scene.boundsWorld = boundsForVoxelsAsWorld(64);
    Settings settings = mobileAt(128);
    settings.grid = 64;
    settings.skyRadiance = glm::vec3(1.0F);
    const glm::dvec3 target(wall + 0.1, floor, 32.0);
    FrameInspector frame(context, scene, noLight(), settings,
                         lookAt(target + glm::dvec3(0.1, 2.5, 0.4), target, 5));
    std::vector<double> light;
    int atWall = 0;
    for (const SeenSurface& seen : frame.seen(Output::irradiance)) {
        if (seen.surface.normal.y < 0.9) continue;
        light.push_back(seen.value.x);
        atWall += seen.surface.positionWorld.x < wall + 0.006 ? 1 : 0;
    }
    ASSERT_GT(atWall, 100);
    std::sort(light.begin(), light.end());
    EXPECT_LE(light.back(), 1.1 * light[light.size() / 2]);
}

// A floor goes on beyond the volume. In the texture of bricks, the faces of another axis follow there: those
// of a bright wall at the volume's other end.
TEST(IrradianceLookUp, APositionBesideTheVolumeTakesTheLightAtItsBorder) {
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    scene.materials[0].baseColor = {0, 0, 0, 1};
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].emissive = glm::vec3(10.0F);
    addQuad(scene, {40, 12, 8}, {0, 0, 48}, {36, 0, 0});
    addQuad(scene, {0.1, 1, 29.5}, {16, 0, 0}, {0, 22, 0});
    addQuad(scene, {0.1, 1, 36.0}, {0, 22, 0}, {16, 0, 0}, 1);
    scene.boundsWorld = boundsForVoxelsAsWorld(64);
    Settings settings = mobileAt(128);
    settings.grid = 64;
    settings.skyRadiance = glm::vec3(1.0F);
    FrameInspector frame(context, scene, noLight(), settings, lookAt({70, 40, 30.3}, {70, 12, 30.2}, 30));
    int beside = 0;
    double least = 1e9, most = 0.0;
    for (const SeenSurface& seen : frame.seen(Output::irradiance)) {
        if (seen.surface.positionWorld.x < 64.0) continue;
        ++beside;
        least = std::min<double>(least, seen.value.x);
        most = std::max<double>(most, seen.value.x);
    }
    ASSERT_GT(beside, 2000);
    EXPECT_GE(least, 0.95);
    EXPECT_LE(most, 1.1);
}

}  // namespace
}  // namespace vct::test
