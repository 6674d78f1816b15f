// Closed forms for packed voxels: an empty volume and a half-space.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr int analyticGrid = 64;
constexpr float skyRadiance = 0.25F;
const std::uint32_t white = shared::packVoxel(8, 8, glm::uvec3(248));

// Lets `edit` change the base level of the packed voxels.
FrameInspector overVoxels(const Context& context, const Scene& scene, const glm::dvec3& directionToLight,
                          const Camera& camera, const std::function<void(Words& base)>& edit) {
    Settings settings = smallSettings(analyticGrid, 96);
    settings.skyRadiance = glm::vec3(skyRadiance);
    FrameInspector frame(context, scene, lightFrom(directionToLight), settings, camera);
    Words base = frame.packedVoxels();
    edit(base);
    frame.replacePackedVoxels(base);
    return frame;
}

TEST(EmptyVolume, IndirectLightIsTheSkyAndNothingIsOccluded) {
    const Context context = openContext(Backend::egl);
    const Scene scene = lonePlane(0.0);
    const Camera camera = lookAt({0, 3, 0.5}, {0, 0, 0}, 40);
    FrameInspector frame = overVoxels(context, scene, {1, 2, 3}, camera,
                                      [](Words& base) { std::fill(base.begin(), base.end(), 0U); });
    for (const auto& [view, right] : {std::pair{Output::indirectLight, double{skyRadiance}},
                                      {Output::ambientVisibility, 1.0},
                                      {Output::sunVisibility, 1.0}}) {
        const Spread spread = frame.spreadOf(view);
        ASSERT_GT(spread.count, 1000);
        EXPECT_EQ(spread.min, right) << outputName(view);
        EXPECT_EQ(spread.max, right) << outputName(view);
    }
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
        for (int level = 0; level <= 6 && distance < analyticGrid; ++level, distance *= 2.0)
            opacity += (1.0 - opacity) * coverage(start + direction * distance, level);
        gathered += (cone == 0 ? 0.25 : 0.15) * opacity;
    }
    return gathered;
}

class HalfSpace : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Axes, HalfSpace, testing::Values(0, 1, 2));

TEST_P(HalfSpace, IsGatheredAsItsClosedFormSays) {
    const int axis = GetParam();
    const Context context = openContext(Backend::egl);
    const Scene scene = lonePlane(0.0);
    // The upper half-space along `axis`, from voxel 32 (48 for the height, clear of the plane itself).
    const int first = axis == 1 ? 48 : 32;
    const auto fill = [&](Words& base) {
        for (std::size_t i = 0; i < base.size(); ++i) {
            const glm::ivec3 voxel(i % analyticGrid, i / analyticGrid % analyticGrid,
                                   i / analyticGrid / analyticGrid);
            base[i] = voxel[axis] >= first ? white : 0U;
        }
    };
    FrameInspector frame = overVoxels(context, scene, {1, 2, 3}, lookAt({0, 3, 0.5}, {0, 0, 0}, 40), fill);
    const std::vector<SeenSurface> seen = frame.seen(Output::indirectLight);
    glm::dvec3 from(0.0);
    from[axis] = first;
    double largest = 0.0;
    for (const auto& [surface, light] : seen) {
        const glm::dvec3 start = surface.positionVolume * (1.0 * analyticGrid) + glm::dvec3(0, 5, 0);
        // The radiance of the half-space is 1, and the sky is behind it.
        const double opacity = halfSpaceGather(start, from, glm::dvec3(analyticGrid));
        ASSERT_NEAR(light.x, opacity + (1.0 - opacity) * skyRadiance, 4e-3)
            << "at " << start.x << " " << start.y << " " << start.z;
        largest = std::max(largest, opacity);
    }
    ASSERT_GT(seen.size(), 1000U);
    EXPECT_GT(largest, axis == 1 ? 0.75 : 0.5);  // the half-space is there
}

}  // namespace
}  // namespace vct::test
