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
    capabilities.limits = {8192, texture3d, 8192, 4};
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

// A room of 10 m whose walls and floor are one mesh, closed at the top by nothing: an outer box and an inner
// one, turned inside out, with a rim between them.
Scene roomOfOneMesh(double thickness) {
    Scene scene = emptyScene();
    const glm::dvec3 outer(10, 4, 10), inner = outer - glm::dvec3(2 * thickness);
    addBox(scene, outer, {0, 0, 0});
    addBox(scene, inner, {0, 0, 0});
    Mesh room;
    room.name = "room";
    for (const Instance& instance : scene.instances) {
        const Mesh& box = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const bool isInner = &box == &scene.meshes.back();
        const auto first = static_cast<std::uint32_t>(room.vertices.size());
        for (Vertex vertex : box.vertices) {
            const glm::dvec3 object = box.centre + glm::dvec3(vertex.position);
            vertex.position = glm::vec3(instance.worldFromObject * glm::dvec4(object, 1.0));
            room.vertices.push_back(vertex);
        }
        for (std::size_t i = 0; i < box.indices.size(); i += 3)
            for (const std::size_t corner : {0U, isInner ? 2U : 1U, isInner ? 1U : 2U})
                room.indices.push_back(first + box.indices[i + corner]);
    }
    // A triangle without area connects the two boxes.
    room.indices.insert(room.indices.end(), {0, 0, static_cast<std::uint32_t>(room.vertices.size() - 1)});
    scene.meshes = {room};
    scene.instances = {Instance{0}};
    return finished(std::move(scene));
}

TEST(GridChoice, MeasuresTheThicknessOfWallsOfOneMesh) {
    const GridChoice thick = choose(roomOfOneMesh(0.3), "thesis");
    EXPECT_EQ(thick.grid, 128) << thick.reason;
    expectMentions(thick.reason, {"up to 30 cm thick", "need voxels of 15 cm"});
    const GridChoice thin = choose(roomOfOneMesh(0.02), "thesis");
    EXPECT_EQ(thin.grid, 512) << thin.reason;
    expectMentions(thin.reason, {"up to 2 cm thick", "need voxels of 1 cm"});
    // Directional voxels keep the sides of a wall apart.
    const GridChoice faces = choose(roomOfOneMesh(0.02), "mobile");
    EXPECT_EQ(faces.grid, 64) << faces.reason;
    expectMentions(faces.reason, {"less than 2 % of the surface", "narrower than two voxels"});
    EXPECT_EQ(faces.reason.find("need voxels of"), std::string::npos) << faces.reason;
}

TEST(GridChoice, IgnoresALittleSurface) {
    EXPECT_EQ(choose(floorWith(1, {0.1, 0.1, 1}), "mobile").grid, 64);
    EXPECT_EQ(choose(floorWith(20, {0.1, 0.1, 1}), "mobile").cascades, 3);
}

TEST(GridChoice, IsLimitedByThePresetAndTheMemory) {
    const Scene scene = floorWith(20, {0.1, 0.05, 1});
    EXPECT_EQ(choose(scene, "quality").grid, 256);
    EXPECT_EQ(choose(floorWith(1, {2, 2, 2}), "quality").grid, 128);

    const GridChoice small = choose(scene, "mobile", DirectionalVoxels::bytesFor(128, 1, 0) - 1);
    EXPECT_EQ(small.grid, 64);
    EXPECT_EQ(small.cascades, 3);  // three cubes of 64^3 are smaller than one of 128^3
    const GridChoice least = choose(scene, "mobile", DirectionalVoxels::bytesFor(64, 1, 0));
    EXPECT_EQ(least.cascades, 1);
    expectMentions(least.reason, {"the finest that memory allows"});
}

// Slats of 10 cm need voxels of 5 cm, and the finest grid of the preset has 8 cm.
TEST(GridChoice, NestsCubesWhereOneCubeOfThePresetIsTooCoarse) {
    const GridChoice nested = choose(floorWith(20, {0.1, 0.1, 1}), "mobile");
    EXPECT_EQ(nested.grid, 64);
    EXPECT_EQ(nested.cascades, 3);
    expectMentions(nested.reason,
                   {"grid 64, 3 cascades: voxels of 4.24 cm around the camera to 16.9 cm", "5 cm"});
    EXPECT_EQ(choose(floorWith(20, {0.1, 0.1, 1}), "thesis").cascades, 1);
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
    const Settings packed = presetSettings("thesis"), mobile = presetSettings("mobile");
    EXPECT_EQ(chooseForVoxelSize(bounds, packed, 1.0).grid, 64);
    EXPECT_EQ(chooseForVoxelSize(bounds, packed, 10.0 / 59 + 1e-9).grid, 64);
    EXPECT_EQ(chooseForVoxelSize(bounds, packed, 10.0 / 59 - 1e-9).grid, 128);
    EXPECT_EQ(chooseForVoxelSize(bounds, packed, 0.02).grid, 512);
    expectMentions(errorOf([&] { chooseForVoxelSize(bounds, packed, 0.01); }),
                   {"512^3, gives this scene voxels of 1.97 cm"});

    const GridChoice dense = chooseForVoxelSize(bounds, mobile, 10.0 / 123 + 1e-9);
    EXPECT_EQ(dense.grid, 128);
    EXPECT_EQ(dense.cascades, 1);
    const GridChoice nested = chooseForVoxelSize(bounds, mobile, 10.0 / 123 - 1e-9);
    EXPECT_EQ(nested.grid, 64);
    EXPECT_EQ(nested.cascades, 3);
    EXPECT_EQ(chooseForVoxelSize(bounds, mobile, 10.0 / 59 / 32 + 1e-9).cascades, 6);
    expectMentions(errorOf([&] { chooseForVoxelSize(bounds, mobile, 10.0 / 59 / 32 - 1e-9); }),
                   {"64^3 with 6 cascades, gives this scene voxels of 5.3 mm"});
}

}  // namespace
}  // namespace vct::test
