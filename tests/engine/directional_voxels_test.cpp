// Directional voxels: coverage and radiance of faces have closed forms, and the lists hold every occupied
// voxel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "scene/camera.h"
#include "scene/framing.h"
#include "scene/light_choice.h"
#include "support/faces.h"
#include "support/frame_inspector.h"
#include "support/lesser_driver.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr int directionalGrid = 64;

Settings directionalSettings() {
    Settings settings = mobileAt(16);
    settings.grid = directionalGrid;
    settings.revoxelize = true;
    return settings;
}

// World units are voxels at any size of the scene, so a wall may be larger than the volume.
FrameInspector inspectorOf(const Context& context, Scene scene, const DirectionalLight& light) {
    scene.boundsWorld = boundsForVoxelsAsWorld(directionalGrid);
    const Camera camera = frameScene(scene, 1.0);
    return {context, std::move(scene), light, directionalSettings(), camera};
}
Faces facesOf(const Context& context, Scene scene, const DirectionalLight& light) {
    return inspectorOf(context, std::move(scene), light).faces();
}
glm::ivec3 voxelOf(std::uint32_t entry) {
    return glm::ivec3(shared::unpackFaceVoxel(entry));
}
int faceOf(std::uint32_t entry) {
    return static_cast<int>(shared::unpackFace(entry));
}

// A quad with this normal around a point; `side` in voxels. Its edges run along no axis, so rounding along
// them averages out.
Scene quadScene(const glm::dvec3& normal, const glm::dvec3& centre, double side) {
    const glm::dvec3 helper = std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 n = glm::normalize(normal);
    const glm::dvec3 across = glm::normalize(glm::cross(helper, n));
    const glm::dvec3 u = side * (std::cos(0.4) * across + std::sin(0.4) * glm::cross(n, across));
    const glm::dvec3 v = glm::cross(n, u);
    Scene scene = emptyScene();
    addQuad(scene, centre - 0.5 * (u + v), u, v);
    return finished(std::move(scene));
}

TEST(FaceCoverage, AWallAcrossTheVolumeIsOpaqueFromItsFrontAlone) {
    const Context context = openContext(Backend::egl);
    constexpr int wall = 21;
    for (int face = 0; face < faceCount; ++face) {
        glm::dvec3 centre(directionalGrid / 2);
        centre[face / 2] = wall + 0.5;
        const Faces faces = facesOf(context, quadScene(faceDirection(face), centre, 1.5 * directionalGrid),
                                    lightFrom({1, 2, 3}));
        EXPECT_EQ(faces.size(), std::size_t{directionalGrid} * directionalGrid);
        for (const auto& [entry, value] : faces) {
            ASSERT_EQ(faceOf(entry), face);
            ASSERT_EQ(voxelOf(entry)[face / 2], wall);
            ASSERT_EQ(value.coverage, 1.0);
            ASSERT_EQ(value.opacity, 1.0);
            ASSERT_NEAR(value.offset, 0.0, 1.0 / 127.5);
        }
    }
}

// Each sample, of sixteen in a column of voxels along the dominant axis k, covers a sixteenth of
// max(0, n.f) / |n_k| of the face f. Their sum is the area of the plane as seen from f.
void expectAreasOfTiltedPlanes(const Context& context) {
    constexpr double side = 30.0;
    for (const glm::dvec3& direction :
         {glm::dvec3(1, 2, 3), glm::dvec3(-3, 1, -0.2), glm::dvec3(0.3, -1, 0.5), glm::dvec3(0, 1, 1),
          glm::dvec3(1, -1, 1), glm::dvec3(std::cos(0.5), 0, std::sin(0.5))}) {
        const glm::dvec3 n = glm::normalize(direction);
        const glm::dvec3 centre(32.2, 31.6, 32.4);
        const Faces base = facesOf(context, quadScene(n, centre, side), lightFrom({1, 2, 3}));
        double area[faceCount] = {};
        for (const auto& [entry, value] : base) {
            const glm::dvec3 middle = glm::dvec3(voxelOf(entry)) + 0.5;
            // The plane meets the voxel, or a rasterizer that snaps to 1/256 of a pixel finds that it does.
            ASSERT_LE(std::abs(glm::dot(n, middle - centre)),
                      0.5 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)) + 1.0 / 128.0);
            // The voxel stores the plane, with 8 bits for each of three numbers.
            EXPECT_GE(glm::dot(value.normal, n), 0.9998);
            EXPECT_NEAR(value.offset, glm::dot(n, centre - middle), 0.015);
            area[faceOf(entry)] += value.coverage;
        }
        for (int face = 0; face < faceCount; ++face) {
            // The columns along the edges, and coverages of 7 bits, are about a per cent of the surface.
            const double seen = side * side * std::max(0.0, glm::dot(n, faceDirection(face)));
            EXPECT_NEAR(area[face], seen, 0.01 * side * side)
                << "towards " << direction.x << " " << direction.y << " " << direction.z << ", face "
                << faceName(face);
        }
    }
}
TEST(FaceCoverage, SumsToTheAreaOfATiltedPlaneAsSeenFromEachFace) {
    expectAreasOfTiltedPlanes(openContext(Backend::egl));
}
TEST(FaceCoverage, SumsToTheSameAreaWhereADriverDoesNotCountSamples) {
    const LesserDriver driver("3.1", "-GL_OES_sample_variables");
    const Context context = openContext(Backend::egl);
    ASSERT_FALSE(context.capabilities.meets("GL_OES_sample_variables"));
    expectAreasOfTiltedPlanes(context);
}

TEST(FaceCoverage, ASheetHasTwoSidesThatAreLitSeparately) {
    const Context context = openContext(Backend::egl);
    for (const bool doubleSided : {false, true})
        for (const double lightY : {1.0, -1.0}) {
            Scene scene = quadScene({0, 1, 0}, {32, 20.5, 32}, 20.0);
            scene.materials[0].doubleSided = doubleSided;
            scene.materials[0].baseColor = glm::vec4(1.0F, 0.5F, 0.25F, 1.0F);
            const glm::dvec3 directionToLight = glm::normalize(glm::dvec3(1, 2 * lightY, 1));
            const DirectionalLight light = lightFrom(directionToLight);
            const Faces base = facesOf(context, scene, light);
            const glm::ivec3 voxel(32, 20, 32);
            for (int face = 0; face < faceCount; ++face) {
                const double facing = faceDirection(face).y;
                const bool covered = facing > 0.0 || (facing < 0.0 && doubleSided);
                ASSERT_EQ(faceAt(base, voxel, face).coverage, covered ? 1.0 : 0.0) << faceName(face);
                for (int c = 0; c < 3; ++c) {
                    const double radiance =
                        covered ? std::max(0.0, facing * directionToLight.y) * scene.materials[0].baseColor[c]
                                : 0.0;
                    EXPECT_NEAR(faceAt(base, voxel, face).radiance[c], radiance, 2e-3)
                        << faceName(face) << (doubleSided ? ", double-sided" : ", single-sided")
                        << ", light from y " << lightY;
                }
            }
        }
}

TEST(FaceCoverage, AMirroredInstanceKeepsItsFrontInFront) {
    const Context context = openContext(Backend::egl);
    // Mirrored along x the front still faces up, mirrored along y it faces down.
    for (const int axis : {0, 1}) {
        Scene scene = quadScene({0, 1, 0}, {0, 0, 0}, 20.0);
        glm::dvec3 scale(1.0);
        scale[axis] = -1.0;
        scene.instances[0].worldFromObject =
            glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(32.3, 20.5, 32.3)), scale);
        scene = finished(std::move(scene));
        const Faces base = facesOf(context, scene, lightFrom({1, 2, 3}));
        const glm::ivec3 voxel(32, 20, 32);
        for (int face = 0; face < faceCount; ++face)
            EXPECT_EQ(faceAt(base, voxel, face).coverage, face == (axis == 0 ? 2 : 3) ? 1.0 : 0.0)
                << faceName(face) << ", mirrored along axis " << axis;
    }
}

TEST(FaceSums, NoSumOverAllTrianglesOverflowsAndSmallScenesLoseNothing) {
    EXPECT_EQ(faceSumUnits(1), 65536.0F);
    for (std::uint64_t triangles = 1; triangles < 1ULL << 32; triangles += 1 + triangles / 3)
        for (const std::uint64_t n : {triangles, triangles + 1}) {
            const float units = faceSumUnits(n);
            ASSERT_GE(units, 1.0F) << n;
            ASSERT_EQ(units, std::floor(units)) << n;
            ASSERT_LE(static_cast<double>(units) * static_cast<double>(n), 4294967295.0) << n;
        }
}

// The same quad `copies` times, half of them white and half of them a quarter white.
Scene coincidentQuads(int copies, double sideVoxels) {
    Scene scene = quadScene({0, 1, 0}, {32.5, 20.5, 32.5}, sideVoxels);
    Mesh& first = scene.meshes[0];
    const std::vector<std::uint32_t> quad = first.indices;
    first.indices.clear();
    for (int i = 0; i < copies / 2; ++i)
        first.indices.insert(first.indices.end(), quad.begin(), quad.end());
    Mesh second = first;
    second.material = 1;
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].baseColor = glm::vec4(0.25F, 0.25F, 0.25F, 1.0F);
    scene.instances.push_back({1, glm::dmat4(1.0)});
    scene.meshes.push_back(std::move(second));
    return scene;
}

// The ground below a floor is in the same voxels. Nobody sees it, so it does not darken the floor.
TEST(FaceSums, AFloorHasItsOwnAlbedoAndNotThatOfTheGroundBelowIt) {
    const Context context = openContext(Backend::egl);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 floor(32.5), ground(32.5), normal(0.0);
        normal[axis] = 1.0;
        floor[axis] = 20.7;
        ground[axis] = 20.4;
        Scene scene = quadScene(normal, floor, 20.0);
        scene.materials[0].baseColor = glm::vec4(0.6F, 0.3F, 0.02F, 1.0F);
        const Scene below = quadScene(normal, ground, 20.0);
        scene.meshes.push_back(below.meshes[0]);
        scene.meshes[1].material = 1;
        scene.materials.push_back(below.materials[0]);
        scene.materials[1].baseColor = glm::vec4(0.9F, 0.9F, 0.9F, 1.0F);
        scene.instances.push_back({1, glm::dmat4(1.0)});
        int covered = 0;
        for (const auto& [entry, value] : facesOf(context, scene, lightFrom(normal))) {
            if (glm::length(glm::dvec3(voxelOf(entry)) + 0.5 - floor) > 8.0) continue;
            ++covered;
            ASSERT_EQ(faceOf(entry), 2 * axis);
            ASSERT_NEAR(value.albedo.r, 0.6, 0.005);
            ASSERT_NEAR(value.albedo.g, 0.3, 0.005);
            ASSERT_NEAR(value.albedo.b, 0.02, 0.002);
        }
        EXPECT_GE(covered, 190);
    }
}

// The test of units shows that there is room for any number of triangles. These have colours of their own.
TEST(FaceSums, OfManyCoincidentTrianglesTheLightestIsSeen) {
    const Context context = openContext(Backend::egl);
    const Scene scene = coincidentQuads(4000, 1.0);
    const DirectionalLight light = lightFrom({0, 1, 0});
    int covered = 0;
    for (const auto& [entry, value] : facesOf(context, scene, light)) {
        ++covered;
        ASSERT_EQ(faceOf(entry), 2);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(value.radiance[c], 1.0, 2e-3);
    }
    EXPECT_GE(covered, 1);
}

class FaceVoxelsOf : public testing::TestWithParam<const char*> {
  protected:
    static Scene scene() { return loadGltf(asset(std::string(GetParam()) + ".glb")); }
};
INSTANTIATE_TEST_SUITE_P(Scenes, FaceVoxelsOf, testing::Values("cornell", "courtyard"),
                         [](const auto& test) { return std::string(test.param); });

std::set<std::uint32_t> withoutDuplicates(const std::vector<std::uint32_t>& entries) {
    const std::set<std::uint32_t> unique(entries.begin(), entries.end());
    EXPECT_EQ(unique.size(), entries.size()) << "entries are listed twice";
    return unique;
}

TEST_P(FaceVoxelsOf, ListsHoldEachOccupiedVoxelAndEachFaceOnce) {
    const Context context = openContext(Backend::egl);
    const Scene scene = FaceVoxelsOf::scene();
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), directionalSettings());
    for (int frame = 0; frame < 2; ++frame)
        renderer.render({{Output::gi}, chooseCamera(scene, "")});
    const DirectionalVoxels& voxels = renderer.directional()->voxels();
    std::vector<std::uint32_t> entries;
    for (const DirectionalVoxels::BaseFace& face : voxels.readBaseFaces())
        entries.push_back(face.entry);
    std::set<std::uint32_t> occupied, ofBlocks;
    for (const std::uint32_t entry : withoutDuplicates(entries)) {
        const glm::uvec3 voxel = shared::unpackFaceVoxel(entry);
        occupied.insert(shared::packEntry(voxel));
        ofBlocks.insert(shared::packFace(voxel >> unsigned{VCT_BRICK_LEVEL}, shared::unpackFace(entry)));
    }
    EXPECT_GT(occupied.size(), 1000U);
    EXPECT_EQ(voxels.index().readActiveCounts().at(0), occupied.size());
    EXPECT_EQ(withoutDuplicates(voxels.readBlockFaces()), ofBlocks);
}

}  // namespace
}  // namespace vct::test
