// Packed voxels of triangles that are sorted by their axis equal those of the geometry shader bit for bit.
#include <gtest/gtest.h>

#include "platform/contexts.h"
#include "scene/camera.h"
#include "support/errors.h"
#include "support/grids.h"
#include "support/moving_scenes.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

gl::Capabilities withoutGeometryShaders(gl::Capabilities capabilities) {
    for (gl::Requirement& row : capabilities.requirements)
        if (row.name == "GL_EXT_geometry_shader") row.met = false;
    return capabilities;
}

Settings settingsFor(const std::string& preset, int grid) {
    Settings settings = presetSettings(preset);
    settings.grid = grid;
    settings.size = glm::ivec2(64);
    settings.shadowMapSize = 256;
    return settings;
}

// The second of two frames has another pose, so leftovers of the first one would show.
Grid voxelized(const Scene& scene, const gl::Capabilities& capabilities) {
    Renderer renderer(scene, lightFrom({1, 2, 3}), settingsFor("thesis", 128), capabilities, testShaders());
    for (const double seconds : {0.0, 0.4}) {
        renderer.setPose(poseAt(scene.animation, seconds));
        renderer.render({{Output::gi}, lookAt({0, 0, 0.9}, {0, 0, -1}, 90)});
    }
    return gridOf(renderer);
}

Scene sceneNamed(const std::string& name) {
    if (name == "deforming") return load(twoThatDeform());
    return loadGltf(asset(name + ".glb"));
}

class SortedAxes : public testing::TestWithParam<std::tuple<Backend, std::string>> {};
INSTANTIATE_TEST_SUITE_P(
    BackendsAndScenes, SortedAxes,
    testing::Values(std::tuple(Backend::egl, "courtyard"), std::tuple(Backend::egl, "deforming"),
                    std::tuple(Backend::zink, "courtyard"), std::tuple(Backend::osmesa, "courtyard")),
    [](const auto& test) {
        return std::string(backendName(std::get<0>(test.param))) + "_" + std::get<1>(test.param);
    });

TEST_P(SortedAxes, GiveTheVoxelsOfTheGeometryShader) {
    const auto& [backend, name] = GetParam();
    VCT_SKIP_IF_ABSENT(backend);
    const Context context = openContext(backend);
    const Scene scene = sceneNamed(name);
    const Grid byShader = voxelized(scene, context.capabilities);
    ASSERT_GT(byShader.lists[0].size(), 1000U);
    ASSERT_EQ(byShader.words.size(), byShader.lists.size());
    expectSameGrid(voxelized(scene, withoutGeometryShaders(context.capabilities)), byShader, name);
}

TEST(Voxelization, EveryPresetRunsWithoutGeometryShadersAndPackedVoxelsSaySo) {
    const Context context = openContext(Backend::egl);
    const gl::Capabilities without = withoutGeometryShaders(context.capabilities);
    const Scene scene = lonePlane(0.0);
    for (const std::string& preset : presetNames())
        EXPECT_NO_THROW(
            Renderer(scene, lightFrom({1, 2, 3}), settingsFor(preset, 64), without, testShaders()))
            << preset;
    expectMentions(voxelizationNote(Voxels::packed, without), {"GL_EXT_geometry_shader", "sorted by axis"});
    EXPECT_EQ(voxelizationNote(Voxels::packed, context.capabilities), "");
    EXPECT_EQ(voxelizationNote(Voxels::directional, without), "");
}

}  // namespace
}  // namespace vct::test
