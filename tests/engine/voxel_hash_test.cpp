// Hashes of all voxels, to compare with those of another processor (scripts/arm64.sh).
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <tuple>

#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/grids.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

// FNV-1a of 64 bits over words.
class Hash {
  public:
    void add(std::uint32_t word) { value_ = (value_ ^ word) * 0x100000001B3U; }
    void add(const std::vector<std::uint32_t>& words) {
        add(static_cast<std::uint32_t>(words.size()));
        for (const std::uint32_t word : words)
            add(word);
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xCBF29CE484222325U;
};

using SceneAndPreset = std::tuple<const char*, const char*>;
class VoxelHash : public testing::TestWithParam<SceneAndPreset> {};
// At one grid, mobile and quality have the same voxels.
INSTANTIATE_TEST_SUITE_P(Scenes, VoxelHash,
                         testing::Combine(testing::Values("cornell", "moving", "courtyard"),
                                          testing::Values("thesis", "mobile")),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
                         });

TEST_P(VoxelHash, IsTheSameForTwoRenderers) {
    const auto [name, preset] = GetParam();
    const Context context = openContext(Backend::egl);
    Scene scene = loadGltf(asset(std::string(name) + ".glb"));
    Settings settings = presetSettings(preset);
    settings.size = {16, 16};
    settings.grid = 64;        // emulated, finer ones take minutes
    settings.lightFrames = 1;  // voxels do not depend on what they receive
    const auto hashes = [&] {
        Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
        renderer.render({{Output::gi}, chooseCamera(scene, "")});
        const Grid grid = gridOf(renderer);
        EXPECT_GT(grid.lists.at(0).size(), 1000U);
        Hash where, what;
        for (const std::vector<std::uint32_t>& entries : grid.lists)
            where.add(entries);
        where.add(grid.blockFaces);
        for (const std::vector<std::uint32_t>& words : grid.words)
            what.add(words);
        for (const auto& [voxel, words] : grid.surfaces) {
            what.add(voxel);
            what.add(words);
        }
        return std::pair(where.value(), what.value());
    };
    const auto first = hashes();
    EXPECT_EQ(hashes(), first);
    // llvmpipe filters textures in other steps on other processors, so the content is compared without
    // textures.
    for (Material& material : scene.materials)
        material.baseColorTexture = material.emissiveTexture = -1;
    const auto plain = hashes();
    std::printf("voxels %s %s: lists %016llx, content %016llx\n", name, preset,
                static_cast<unsigned long long>(first.first), static_cast<unsigned long long>(plain.second));
}

}  // namespace
}  // namespace vct::test
