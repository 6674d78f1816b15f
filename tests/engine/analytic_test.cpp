// Truths that need no renderer (design: empty volume, furnace, lone plane, half-space).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "platform/contexts.h"
#include "scene/camera.h"
#include "support/gather.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr int grid = 64;
const std::uint32_t white = shared::packVoxel(8, 8, glm::uvec3(248));

Settings settings() {
    Settings s;
    s.grid = grid;
    s.size = glm::ivec2(96);
    return s;
}

struct Spread {
    double mean, min, max;
};
Spread spreadOf(const std::vector<float>& values) {
    return {std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()),
            *std::min_element(values.begin(), values.end()), *std::max_element(values.begin(), values.end())};
}

// Without geometry in the voxels nothing is seen, nothing occludes: exactly.
TEST(EmptyVolume, IndirectIsZeroOcclusionAndShadowAreOne) {
    const Context context = openContext(Backend::egl);
    const Scene scene = lonePlane(0.0);
    const Camera camera = lookAt({0, 3, 0.5}, {0, 0, 0}, 40);
    const auto empty = [](Words& base) { std::fill(base.begin(), base.end(), 0U); };
    const auto view = [&](int which) {
        return gatherOver(context, scene, lightFrom({1, 2, 3}), settings(), camera, which, empty).values;
    };
    ASSERT_GT(view(VCT_VIEW_AO).size(), 1000U);
    for (float value : view(VCT_VIEW_INDIRECT))
        ASSERT_EQ(value, 0.0F);
    for (float value : view(VCT_VIEW_AO))
        ASSERT_EQ(value, 1.0F);
    for (float value : view(VCT_VIEW_CONE_SHADOW))
        ASSERT_EQ(value, 1.0F);
}

// The cone trace over a half-space that ends at voxel faces of every level used: trilinear interpolation of a
// box is a product of one ramp per axis, so each sample has a closed form.
double halfSpaceGather(const glm::dvec3& start, const glm::dvec3& from, const glm::dvec3& to) {
    const double ring[5][3] = {{0.0, 0.5, 0.866025},
                               {0.823639, 0.5, 0.267617},
                               {0.509037, 0.5, -0.700629},
                               {-0.509037, 0.5, -0.700629},
                               {-0.823639, 0.5, 0.267617}};
    const auto coverage = [&](const glm::dvec3& voxels, int level) {
        const double size = std::exp2(level);
        double product = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double x = voxels[axis] / size;
            product *= std::clamp(x - from[axis] / size + 0.5, 0.0, 1.0) *
                       std::clamp(to[axis] / size - x + 0.5, 0.0, 1.0);
        }
        return product;
    };
    double gathered = 0.0;
    for (int cone = 0; cone < 6; ++cone) {
        const glm::dvec3 direction =
            cone == 0 ? glm::dvec3(0, 1, 0)
                      : glm::dvec3(ring[cone - 1][0], ring[cone - 1][1], ring[cone - 1][2]);
        double opacity = 0.0;
        double distance = 2.5;
        for (int level = 0; level <= 6 && distance < grid; ++level, distance *= 2.0)
            opacity += (1.0 - opacity) * coverage(start + direction * distance, level);
        gathered += (cone == 0 ? 0.25 : 0.15) * opacity;
    }
    return gathered;
}

class HalfSpace : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Axes, HalfSpace, testing::Values(0, 1, 2));

TEST_P(HalfSpace, GatherEqualsTheClosedForm) {
    const int axis = GetParam();
    const Context context = openContext(Backend::egl);
    const Scene scene = lonePlane(0.0);
    // The upper half-space along `axis`, from voxel 32 (48 for the height, clear of the plane itself).
    const int first = axis == 1 ? 48 : 32;
    const auto fill = [&](Words& base) {
        for (int z = 0; z < grid; ++z)
            for (int y = 0; y < grid; ++y)
                for (int x = 0; x < grid; ++x)
                    base[(static_cast<std::size_t>(z) * grid + y) * grid + x] =
                        glm::ivec3(x, y, z)[axis] >= first ? white : 0U;
    };
    const GatherResult result = gatherOver(context, scene, lightFrom({1, 2, 3}), settings(),
                                           lookAt({0, 3, 0.5}, {0, 0, 0}, 40), VCT_VIEW_INDIRECT, fill);
    ASSERT_GT(result.values.size(), 1000U);
    glm::dvec3 from(0.0);
    from[axis] = first;
    double largest = 0.0;
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        const glm::dvec3 start = result.positions[i] * static_cast<double>(grid) + glm::dvec3(0, 5, 0);
        const double expected = halfSpaceGather(start, from, glm::dvec3(grid));
        ASSERT_NEAR(result.values[i], expected, 4e-3) << "at " << start.x << " " << start.y << " " << start.z;
        largest = std::max(largest, expected);
    }
    EXPECT_GT(largest, axis == 1 ? 0.75 : 0.5);  // the half-space is there
}

// The wall of closedBox() that a point lies on, by the normal of its inside: 0..5 for +x, -x, +y, -y, +z, -z.
int wallOf(const glm::dvec3& positionVolume, const Scene& scene, int gridSize) {
    const glm::dmat4 worldFromVolume =
        glm::inverse(volumeAround(scene.boundsWorld, gridSize).volumeFromWorld());
    const glm::dvec3 p =
        glm::inverse(scene.instances[0].worldFromObject) * worldFromVolume * glm::dvec4(positionVolume, 1.0);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(p[i]) > std::abs(p[axis])) axis = i;
    return 2 * axis + (p[axis] > 0.0 ? 1 : 0);
}

// A closed box whose every voxel has radiance 1: the right answer is 1 for every normal.
class Furnace : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Degrees, Furnace, testing::Values(0, 30));

TEST_P(Furnace, ThesisPresetIsReported) {
    const Context context = openContext(Backend::egl);
    const Scene scene = closedBox(GetParam());
    const auto light = [](Words& base) {
        for (std::uint32_t& word : base)
            word = word != 0U ? white : 0U;
    };
    Settings s = settings();
    for (s.grid = 64; s.grid <= 256; s.grid *= 4) {
        const GatherResult result =
            gatherOver(context, scene, lightFrom({1, 2, 3}), s, lookAt({0, 0, 0}, {0.2, -0.4, -1}, 120),
                       VCT_VIEW_INDIRECT, light);
        const Spread spread = spreadOf(result.values);
        std::printf("furnace turned by %d degrees, %d^3: mean %.3f, min %.3f, max %.3f (right: 1)\n",
                    GetParam(), s.grid, spread.mean, spread.min, spread.max);
        const char* normals[6] = {"+x", "-x", "+y", "-y", "+z", "-z"};
        std::vector<float> ofWall[6];
        for (std::size_t i = 0; i < result.values.size(); ++i)
            ofWall[wallOf(result.positions[i], scene, s.grid)].push_back(result.values[i]);
        for (int wall = 0; wall < 6; ++wall)
            if (!ofWall[wall].empty()) {
                const Spread w = spreadOf(ofWall[wall]);
                std::printf("  normal %s: mean %.3f, min %.3f, max %.3f\n", normals[wall], w.mean, w.min,
                            w.max);
                EXPECT_GT(w.mean, 0.4) << normals[wall];
            }
        // The published constants lose light to their start offsets and skipped levels; they never add any.
        EXPECT_GT(spread.mean, 0.5);
        EXPECT_GT(spread.min, 0.1);
        EXPECT_LT(spread.max, 1.01);
    }
}

// One lit plane in an empty volume: a surface does not light itself, so the right answer is 0.
class LonePlane : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Degrees, LonePlane, testing::Values(0, 30));

TEST_P(LonePlane, ThesisPresetIsReported) {
    const Context context = openContext(Backend::egl);
    const Scene scene = lonePlane(GetParam());
    const glm::dvec3 up(scene.instances[0].worldFromObject * glm::dvec4(0, 1, 0, 0));
    const auto unchanged = [](Words&) {};
    Settings s = settings();
    for (s.grid = 64; s.grid <= 256; s.grid *= 4) {
        const GatherResult result =
            gatherOver(context, scene, lightFrom(up), s,
                       lookAt(3.0 * up + glm::dvec3(0.3, 0, 0), {0, 0, 0}, 40), VCT_VIEW_INDIRECT, unchanged);
        const Spread spread = spreadOf(result.values);
        std::printf("lone plane turned by %d degrees, %d^3: mean %.3f, min %.3f, max %.3f (right: 0)\n",
                    GetParam(), s.grid, spread.mean, spread.min, spread.max);
        EXPECT_GE(spread.min, 0.0);
        EXPECT_LT(spread.max, 0.5);
    }
}

}  // namespace
}  // namespace vct::test
