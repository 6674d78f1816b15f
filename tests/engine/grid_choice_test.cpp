#include "engine/grid_choice.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "engine/directional/directional_voxels.h"
#include "support/errors.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr std::size_t enough = std::numeric_limits<std::size_t>::max();

// A floor of 10 m with boxes on it: voxels are 16.9, 8.1, 4.0 or 2.0 cm wide.
Scene floorWith(int boxes, const glm::dvec3& sides) {
    Scene scene = emptyScene();
    addQuad(scene, {-5, 0, -5}, {0, 0, 10}, {10, 0, 0});
    for (int i = 0; i < boxes; ++i)
        addBox(scene, sides, {0.1 * i, 1, 0});
    for (Mesh& mesh : scene.meshes)
        mesh.name = "slat";
    scene.meshes[0].name = "floor";
    return finished(std::move(scene));
}

gl::Capabilities driverWith(int texture3d) {
    gl::Capabilities capabilities;
    capabilities.limits = {8192, texture3d, 8192, 4, 8};
    return capabilities;
}

GridChoice choose(const Scene& scene, const std::string& preset, std::size_t bytes = enough) {
    return chooseGrid(scene, presetSettings(preset), driverWith(2048), bytes);
}

TEST(GridChoice, HasTwoVoxelsAcrossTheNarrowestParts) {
    // 20 slats of 0.4 m^2 and more beside 100 m^2.
    EXPECT_EQ(choose(floorWith(20, {0.35, 0.35, 1}), "mobile").grid, 64);
    const GridChoice narrow = choose(floorWith(20, {0.17, 0.17, 1}), "mobile");
    EXPECT_EQ(narrow.grid, 128);
    expectMentions(narrow.reason, {"grid 128: voxels of 8.13 cm", "17 cm wide (\"slat\")"});
}

TEST(GridChoice, FollowsRodsAndWithPackedVoxelsWallsToo) {
    const Scene walls = floorWith(4, {3, 2, 0.1});
    EXPECT_EQ(choose(walls, "mobile").grid, 64);
    const GridChoice words = choose(walls, "thesis");
    EXPECT_EQ(words.grid, 256);
    expectMentions(words.reason, {"10 cm thick"});
}

TEST(GridChoice, IgnoresALittleSurface) {
    EXPECT_EQ(choose(floorWith(1, {0.1, 0.1, 1}), "mobile").grid, 64);
    EXPECT_EQ(choose(floorWith(20, {0.1, 0.1, 1}), "mobile").grid, 128);
}

TEST(GridChoice, IsLimitedByThePresetAndTheMemory) {
    const Scene scene = floorWith(20, {0.1, 0.05, 1});
    const GridChoice finest = choose(scene, "mobile");
    EXPECT_EQ(finest.grid, 128);
    expectMentions(finest.reason, {"the finest of this preset"});
    EXPECT_EQ(choose(scene, "quality").grid, 256);
    EXPECT_EQ(choose(floorWith(1, {2, 2, 2}), "quality").grid, 128);

    const GridChoice small = choose(scene, "mobile", DirectionalVoxels::bytesFor(128, 0) - 1);
    EXPECT_EQ(small.grid, 64);
    expectMentions(small.reason, {"the finest that memory allows"});
    EXPECT_EQ(choose(scene, "mobile", DirectionalVoxels::bytesFor(128, 0)).grid, 128);
}

TEST(GridChoice, WarnsOfPartsSmallerThanAVoxel) {
    const auto warning = [](double across, int grid) {
        Settings settings = presetSettings("mobile");
        settings.grid = grid;
        return coarseGridWarning(floorWith(20, {across, across, 1}), settings);
    };
    EXPECT_EQ(warning(0.17, 64), "");
    expectMentions(warning(0.16, 64), {"16 cm wide (\"slat\"), less than a voxel"});
    EXPECT_EQ(warning(0.16, 128), "");
}

// Columns and slats are narrower than two voxels of 64^3.
TEST(GridChoice, IsFineForScenesWithColumnsOrSlatsAlone) {
    for (const char* name : {"courtyard", "corridor"})
        EXPECT_EQ(choose(loadGltf(asset(std::string(name) + ".glb")), "mobile").grid, 128) << name;
    for (const char* name : {"cornell", "cornell_1mm", "cornell_10km", "contact", "glossy", "thin_wall",
                             "dim_room", "furnace", "lamp", "lone_plane"})
        EXPECT_EQ(choose(loadGltf(asset(std::string(name) + ".glb")), "mobile").grid, 64) << name;
}

TEST(GridChoice, IsTheCoarsestWithVoxelsOfAGivenSize) {
    const Bounds bounds{{0, 0, 0}, {10, 1, 1}};  // 10 m over 59, 123, 251 or 507 voxels
    EXPECT_EQ(gridForVoxelSize(bounds, 1.0), 64);
    EXPECT_EQ(gridForVoxelSize(bounds, 10.0 / 59 + 1e-9), 64);
    EXPECT_EQ(gridForVoxelSize(bounds, 10.0 / 59 - 1e-9), 128);
    EXPECT_EQ(gridForVoxelSize(bounds, 0.02), 512);
    expectMentions(errorOf([&] { gridForVoxelSize(bounds, 0.01); }),
                   {"512^3, gives this scene voxels of 1.97 cm"});
}

}  // namespace
}  // namespace vct::test
