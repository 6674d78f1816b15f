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
std::vector<FaceLevel> facesOf(const Context& context, Scene scene, const DirectionalLight& light) {
    return inspectorOf(context, std::move(scene), light).faceLevels();
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

TEST(FaceCoverage, AWallAcrossTheVolumeIsOpaqueFromItsFrontAloneAtEveryLevel) {
    const Context context = openContext(Backend::egl);
    constexpr int wall = 21;  // odd, so it is behind its sibling for half of the faces
    for (int face = 0; face < faceCount; ++face) {
        glm::dvec3 centre(directionalGrid / 2);
        centre[face / 2] = wall + 0.5;
        const std::vector<FaceLevel> levels = facesOf(
            context, quadScene(faceDirection(face), centre, 1.5 * directionalGrid), lightFrom({1, 2, 3}));
        ASSERT_EQ(levels.size(), 7U);
        for (std::size_t level = 0; level < levels.size(); ++level)
            levels[level].forEachVoxel([&](const glm::ivec3& voxel) {
                const bool inWall = voxel[face / 2] == wall >> level;
                for (int f = 0; f < faceCount; ++f)
                    ASSERT_EQ(levels[level].at(voxel, f).a, inWall && f == face ? 255 : 0)
                        << "wall towards " << faceName(face) << ", level " << level << ", face "
                        << faceName(f) << " of voxel " << voxel.x << " " << voxel.y << " " << voxel.z;
            });
    }
}

// Each column of voxels along the dominant axis k has one fragment, which covers max(0, n.f) / |n_k| of the
// face f. Their sum is the area of the plane as seen from f.
TEST(FaceCoverage, SumsToTheAreaOfATiltedPlaneAsSeenFromEachFace) {
    const Context context = openContext(Backend::egl);
    constexpr double side = 30.0;
    for (const glm::dvec3& direction :
         {glm::dvec3(1, 2, 3), glm::dvec3(-3, 1, -0.2), glm::dvec3(0.3, -1, 0.5), glm::dvec3(0, 1, 1),
          glm::dvec3(1, -1, 1), glm::dvec3(std::cos(0.5), 0, std::sin(0.5))}) {
        const glm::dvec3 n = glm::normalize(direction);
        const double dominant = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
        const glm::dvec3 centre(32.2, 31.6, 32.4);
        const FaceLevel base = facesOf(context, quadScene(n, centre, side), lightFrom({1, 2, 3}))[0];
        for (int face = 0; face < faceCount; ++face) {
            const double share = std::max(0.0, glm::dot(n, faceDirection(face))) / dominant;
            double area = 0.0;
            base.forEachVoxel([&](const glm::ivec3& voxel) {
                const double alpha = base.at(voxel, face).a / 255.0;
                if (!base.occupied(voxel)) return;
                // The plane meets the voxel, or a rasterizer that snaps to 1/256 of a pixel finds that it
                // does.
                ASSERT_LE(std::abs(glm::dot(n, glm::dvec3(voxel) + 0.5 - centre)),
                          0.5 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)) + 1.0 / 128.0);
                // The tolerance is that of 8 bits and of rounding in fixed point and derivatives.
                ASSERT_NEAR(alpha, share, 0.51 / 255.0) << faceName(face);
                area += alpha;
            });
            // The columns along the edges are about a per cent of the surface.
            const double seen = side * side * share * dominant;
            EXPECT_NEAR(area, seen, 0.01 * side * side) << "towards " << direction.x << " " << direction.y
                                                        << " " << direction.z << ", face " << faceName(face);
        }
    }
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
            FrameInspector frame = inspectorOf(context, scene, light);
            const FaceLevel base = frame.faceLevels()[0];
            const double range = frame.faceRange();
            const glm::ivec3 voxel(32, 20, 32);
            for (int face = 0; face < faceCount; ++face) {
                const double facing = faceDirection(face).y;
                const bool covered = facing > 0.0 || (facing < 0.0 && doubleSided);
                ASSERT_EQ(base.at(voxel, face).a, covered ? 255 : 0) << faceName(face);
                for (int c = 0; c < 3; ++c) {
                    const double radiance =
                        covered ? std::max(0.0, facing * directionToLight.y) * scene.materials[0].baseColor[c]
                                : 0.0;
                    EXPECT_NEAR(base.at(voxel, face)[c], 255.0 * radiance / range, 1.0)
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
        const FaceLevel base = facesOf(context, scene, lightFrom({1, 2, 3}))[0];
        const glm::ivec3 voxel(32, 20, 32);
        for (int face = 0; face < faceCount; ++face)
            EXPECT_EQ(base.at(voxel, face).a, face == (axis == 0 ? 2 : 3) ? 255 : 0)
                << faceName(face) << ", mirrored along axis " << axis;
    }
}

TEST(FaceSums, NoSumOverAllTrianglesOverflowsAndSmallScenesLoseNothing) {
    EXPECT_EQ(faceSumUnits(1), 4096.0F);
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

// The test above shows that there is room for any number of triangles. These fill an eighth of it.
TEST(FaceSums, ManyCoincidentTrianglesGiveTheirMean) {
    const Context context = openContext(Backend::egl);
    const Scene scene = coincidentQuads(62000, 1.0);
    const DirectionalLight light = lightFrom({0, 1, 0});
    FrameInspector frame = inspectorOf(context, scene, light);
    const FaceLevel base = frame.faceLevels()[0];
    const double range = frame.faceRange();
    int covered = 0;
    base.forEachVoxel([&](const glm::ivec3& voxel) {
        for (int face = 0; face < faceCount; ++face) {
            const glm::u8vec4& value = base.at(voxel, face);
            if (value == glm::u8vec4(0)) continue;
            ++covered;
            ASSERT_EQ(face, 2) << faceName(face);
            ASSERT_EQ(value.a, 255);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(value[c], 255.0 * 0.625 / range, 1.0);
        }
    });
    EXPECT_GE(covered, 1);
}

class FaceVoxelsOf : public testing::TestWithParam<const char*> {
  protected:
    static Scene scene() { return loadGltf(asset(std::string(GetParam()) + ".glb")); }
};
INSTANTIATE_TEST_SUITE_P(Scenes, FaceVoxelsOf, testing::Values("cornell", "courtyard"),
                         [](const auto& test) { return std::string(test.param); });

// Faces do not reflect their irradiance in this mode.
constexpr Output modeWithoutIrradiance = Output::ao;

TEST_P(FaceVoxelsOf, MipLevelsEqualTheCpusWithinOneOf255) {
    const Context context = openContext(Backend::egl);
    const Scene scene = FaceVoxelsOf::scene();
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), directionalSettings());
    renderer.render({{modeWithoutIrradiance}, chooseCamera(scene, "")});
    const std::vector<FaceLevel> levels = readFaces(renderer.directional()->voxels());
    for (std::size_t level = 1; level < levels.size(); ++level)
        EXPECT_LE(maxDifference(levels[level], faceMipOnCpu(levels[level - 1])), 1) << "level " << level;
}

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
        renderer.render({{modeWithoutIrradiance}, chooseCamera(scene, "")});
    const DirectionalVoxels& voxels = renderer.directional()->voxels();
    const FaceLevel base = readFaceLevel(voxels, 0);
    std::set<std::uint32_t> expected;
    base.forEachVoxel([&](const glm::ivec3& voxel) {
        if (base.occupied(voxel)) expected.insert(shared::packEntry(glm::uvec3(voxel)));
    });
    EXPECT_GT(expected.size(), 1000U);
    for (int level = 0; level < voxels.levels(); ++level) {
        std::set<std::uint32_t> voxelsOfFaces, parents;
        for (const std::uint32_t face : withoutDuplicates(voxels.readFaceList(level)))
            voxelsOfFaces.insert(shared::packEntry(shared::unpackFaceVoxel(face)));
        EXPECT_EQ(withoutDuplicates(voxels.index().readList(level)), expected) << "level " << level;
        EXPECT_EQ(voxelsOfFaces, expected) << "level " << level;
        for (const std::uint32_t entry : expected)
            parents.insert(shared::packEntry(shared::unpackEntry(entry) / 2U));
        expected = parents;
    }
}

}  // namespace
}  // namespace vct::test
