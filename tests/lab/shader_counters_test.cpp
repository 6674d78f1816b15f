// What the shaders count of themselves against the CPU's cones, the pixels and the active voxels.
#include "lab/shader_counters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "scene/camera.h"
#include "support/cpu_packed_cones.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"

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

Counted counted(Settings settings) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    settings.countInvocations = true;
    settings.revoxelize = true;
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
    return {countInvocations(renderer, Mode::giConeShadow, chooseCamera(scene, "")), renderer.activeVoxels()};
}

TEST(ShaderCounters, AreThoseOfTheCpusCones) {
    const Settings settings = smallSettings(64, pixelsAlongASide);
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    FrameInspector frame(context, scene, chooseLight(scene), settings, chooseCamera(scene, ""));
    const CpuConeTracer cpu(frame.packedLevels(), frame.uniforms());
    double surfaces = 0.0, diffuseSteps = 0.0, shadowSteps = 0.0;
    for (const SurfacePixel& pixel : frame.pixels()) {
        if (!pixel.surface) continue;
        surfaces += 1.0;
        diffuseSteps += cpu.gather(pixel.positionVolume, pixel.normal, 1.0).steps;
        if (glm::dot(pixel.normal, glm::dvec3(frame.uniforms().towardsLight)) > 0.0)
            shadowSteps += cpu.shadow(pixel.positionVolume, pixel.normal).steps;
    }
    const StageCount tracer = stage(counted(settings).counts, "passes/shade.frag");
    EXPECT_EQ(tracer.invocations, pixelsAlongASide * pixelsAlongASide);
    EXPECT_EQ(iterations(tracer, "diffuse cone"), 6.0 * surfaces);
    std::printf("  diffuse steps %.0f (CPU %.0f), shadow steps %.0f (CPU %.0f)\n",
                iterations(tracer, "diffuse step"), diffuseSteps, iterations(tracer, "shadow step"),
                shadowSteps);
    // Where rounding decides whether a cone goes on, one of them takes a step more.
    EXPECT_NEAR(iterations(tracer, "diffuse step") / diffuseSteps, 1.0, 1e-3);
    EXPECT_NEAR(iterations(tracer, "shadow step") / shadowSteps, 1.0, 1e-3);
}

TEST(ShaderCounters, AreThoseOfTheActiveVoxels) {
    const Counted found = counted(smallSettings(64, pixelsAlongASide));
    const auto& active = found.activeVoxels;
    const double all = std::accumulate(active.begin(), active.end(), 0.0);
    EXPECT_EQ(iterations(stage(found.counts, "packed/clear.comp"), "voxel"), all);
    EXPECT_EQ(iterations(stage(found.counts, "packed/mipmapper.comp"), "voxel"), all - active.back());
    EXPECT_GE(stage(found.counts, "packed/voxelizer.frag").invocations, active.front());
}

TEST(ShaderCounters, OfTheSoftShadowAreItsTaps) {
    Settings settings = smallSettings(64, pixelsAlongASide);
    settings.shadow = Shadow::softMap;
    settings.filterTaps = 7;
    const StageCount tracer = stage(counted(settings).counts, "passes/shade.frag");
    const double searches = iterations(tracer, "blocker tap") / 8.0;
    const double penumbrae = iterations(tracer, "filter tap") / 7.0;
    EXPECT_EQ(searches, std::floor(searches));
    EXPECT_EQ(penumbrae, std::floor(penumbrae));
    EXPECT_LT(penumbrae, searches);  // none where nothing blocks the sun
    EXPECT_LT(searches, pixelsAlongASide * pixelsAlongASide);
    for (const LoopCount& loop : tracer.loops)
        EXPECT_NE(loop.name, "shadow step");
}

}  // namespace
}  // namespace vct::test
