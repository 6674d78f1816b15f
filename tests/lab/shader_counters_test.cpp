// What the shaders count of themselves against what is known of a plane's cones, the pixels and the active
// voxels.
#include "lab/shader_counters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr int pixelsAlongASide = 64;

const StageCount& stage(const std::vector<StageCount>& counts, const std::string& shader) {
    const auto found = std::find_if(counts.begin(), counts.end(),
                                    [&](const StageCount& count) { return count.shader == shader; });
    if (found == counts.end()) throw std::runtime_error(shader + " was not counted");
    return *found;
}

double iterations(const StageCount& stage, const std::string& loop) {
    for (const LoopCount& count : stage.loops)
        if (count.name == loop) return count.iterations;
    throw std::runtime_error(loop + " was not counted");
}

struct Counted {
    std::vector<StageCount> counts;
    std::vector<std::uint32_t> activeVoxels;
};

Counted counted(const Scene& scene, const Camera& camera, Settings settings) {
    const Context context = openContext(Backend::egl);
    settings.countInvocations = true;
    settings.revoxelize = true;
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
    return {countInvocations(renderer, Output::giConeShadow, camera), renderer.activeVoxels()};
}

Counted countedOfCornell(const Settings& settings) {
    const Scene scene = loadGltf(asset("cornell.glb"));
    return counted(scene, chooseCamera(scene, ""), settings);
}

// The plane fills the picture. A cone starts 5 of 64 voxels above it, in the middle of the volume, and takes
// a sample of level l at 2.5 * 2^l voxels, no farther than the volume's side: five. But along the normal the
// fifth lies more than half its size outside.
TEST(ShaderCounters, ConesOfAPlaneEndWhereTheVolumeDoes) {
    const Counted found =
        counted(lonePlane(0.0), lookAt({0, 0.5, 0.001}, {0, 0, 0}, 40), smallSettings(64, pixelsAlongASide));
    const StageCount tracer = stage(found.counts, "passes/shade.frag");
    const double pixels = pixelsAlongASide * pixelsAlongASide;
    EXPECT_EQ(tracer.invocations, pixels);
    EXPECT_EQ(iterations(tracer, "diffuse cone"), 6.0 * pixels);
    EXPECT_LE(iterations(tracer, "diffuse step"), (4.0 + 5.0 * 5.0) * pixels);
    EXPECT_GE(iterations(tracer, "diffuse step"), (4.0 + 5.0 * 4.0) * pixels);
    EXPECT_GT(iterations(tracer, "shadow step"), pixels);
}

TEST(ShaderCounters, AreThoseOfTheActiveVoxels) {
    const Counted found = countedOfCornell(smallSettings(64, pixelsAlongASide));
    const auto& active = found.activeVoxels;
    const double all = std::accumulate(active.begin(), active.end(), 0.0);
    EXPECT_EQ(iterations(stage(found.counts, "packed/clear.comp"), "voxel"), all);
    EXPECT_EQ(iterations(stage(found.counts, "packed/mipmapper.comp"), "voxel"), all - active.back());
    EXPECT_GE(stage(found.counts, "packed/voxelizer.frag").invocations, active.front());
}

TEST(ShaderCounters, OfTheSoftShadowAreItsTaps) {
    Settings settings = smallSettings(64, pixelsAlongASide);
    settings.shadow = Shadow::softMap;
    settings.filterTaps = 12;
    const StageCount tracer = stage(countedOfCornell(settings).counts, "passes/shade.frag");
    const double searches = iterations(tracer, "blocker tap") / 7.0;
    const double penumbrae = iterations(tracer, "filter tap") / 3.0;
    EXPECT_EQ(searches, std::floor(searches));
    EXPECT_EQ(penumbrae, std::floor(penumbrae));
    EXPECT_LT(penumbrae, searches);  // none where nothing blocks the sun
    EXPECT_LT(searches, pixelsAlongASide * pixelsAlongASide);
    for (const LoopCount& loop : tracer.loops)
        EXPECT_NE(loop.name, "shadow step");
}

}  // namespace
}  // namespace vct::test
