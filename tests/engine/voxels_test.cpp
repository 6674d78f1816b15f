// Packed voxels, exact to the bit.
#include <gtest/gtest.h>

#include <set>

#include "gl/read_back.h"
#include "lab/cpu_mips.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/errors.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

std::vector<Words> readPyramid(Renderer& renderer) {
    std::vector<Words> levels;
    for (int level = 0; level < renderer.packed()->occupancy().levels(); ++level)
        levels.push_back(readVoxels(renderer.packed()->occupancy().texture(), level));
    return levels;
}

// The voxels of a scene file after one frame. `seed`: of the order of triangles; 0: that of the file.
std::vector<Words> voxelsOf(const std::string& name, unsigned seed = 0) {
    const Context context = openContext(Backend::egl);
    Scene scene = loadGltf(asset(name + ".glb"));
    if (seed != 0) shuffleTriangles(scene, seed);
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), smallSettings(128));
    renderer.render({{Output::gi}, chooseCamera(scene, "")});
    return readPyramid(renderer);
}

class Voxels : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Voxels, testing::Values("cornell", "courtyard"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(Voxels, HaveWholeCountsAtTheBaseAndExactMipLevelsInAnyOrderOfTriangles) {
    const std::vector<Words> levels = voxelsOf(GetParam());
    std::size_t lit = 0, unlit = 0;
    for (const std::uint32_t word : levels[0]) {
        if (word == 0) continue;
        ASSERT_EQ(shared::voxelCount(word), 8U);
        const std::uint32_t light = shared::voxelLight(word);
        ASSERT_TRUE(light == 0 || light == 8) << light;
        ++(light != 0 ? lit : unlit);
    }
    EXPECT_GT(lit, 1000U);
    EXPECT_GT(unlit, 1000U);
    ASSERT_EQ(levels.size(), 8U);
    for (std::size_t level = 1; level < levels.size(); ++level)
        ASSERT_EQ(levels[level], mipOnCpu(levels[level - 1], 128 >> (level - 1))) << "level " << level;
    EXPECT_EQ(voxelsOf(GetParam(), 1), levels);
}

TEST(VoxelList, OverflowIsReportedAndNeverWrittenPast) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    Settings settings = smallSettings();
    settings.revoxelize = true;
    Renderer roomy = makeRenderer(context, scene, chooseLight(scene), settings);
    roomy.render({{Output::gi}, chooseCamera(scene, "")});
    const std::string needed = std::to_string(roomy.activeVoxels()[0]);
    settings.activeVoxelLimit = 1000;
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
    renderer.render({{Output::gi}, chooseCamera(scene, "")});
    const auto expectReport = [&] {
        expectMentions(errorOf([&] { renderer.activeVoxels(); }), {"active voxels", "room for " + needed});
    };
    expectReport();
    const Words first = readVoxels(renderer.packed()->occupancy().texture(), 0);
    // The list of level 1 follows that of level 0 and is not full, so a second frame must not write behind
    // its last entry.
    const VoxelPyramid& pyramid = renderer.packed()->occupancy();
    ASSERT_EQ(pyramid.firstEntry(1), 1000U);
    std::set<std::uint32_t> parents;
    for (std::uint32_t entry : readEntries(pyramid, 0, 1000))
        parents.insert(shared::packEntry(shared::unpackEntry(entry) / 2U));
    ASSERT_LT(parents.size(), 900U);
    const std::vector<std::uint32_t> untouched(100, 0xC0FFEEU);
    pyramid.activeVoxels().bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, (1000 + 900) * sizeof(std::uint32_t), 100 * sizeof(std::uint32_t),
                      untouched.data());
    renderer.render({{Output::gi}, chooseCamera(scene, "")});
    expectReport();
    EXPECT_EQ(readVoxels(renderer.packed()->occupancy().texture(), 0), first);
    const std::vector<std::uint32_t> level1 = readEntries(pyramid, 1, 1000);
    EXPECT_EQ(std::vector<std::uint32_t>(level1.end() - 100, level1.end()), untouched);
}

TEST(VoxelizerHardCases, DegenerateAndEdgeOnTrianglesMakeNoNaNAndNoExtraVoxel) {
    const Context context = openContext(Backend::egl);
    Scene scene = closedBox(0.0);
    const auto before = [&] {
        Renderer renderer = makeRenderer(context, scene, lightFrom({1, 2, 3}), smallSettings());
        renderer.render({{Output::gi}, lookAt({0, 0, 0.9}, {0, 0, -1}, 90)});
        for (const glm::vec3& pixel : renderer.radiance().pixels)
            for (int c = 0; c < 3; ++c)
                EXPECT_TRUE(std::isfinite(pixel[c]));
        return readVoxels(renderer.packed()->occupancy().texture(), 0);
    };
    const Words reference = before();
    Mesh needle = scene.meshes[0];
    needle.vertices[1] = needle.vertices[0];  // two corners in one place
    needle.vertices[2] = needle.vertices[3] = needle.vertices[0];
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
    scene.meshes.push_back(needle);
    EXPECT_EQ(before(), reference);
}

}  // namespace
}  // namespace vct::test
