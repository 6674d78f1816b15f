// Occupied voxels against an exact triangle-cube overlap: how many the rasterizer misses, and that it makes
// none up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <random>

#include "lab/read_back.h"
#include "scene/camera.h"
#include "support/cpu_voxelizer.h"
#include "support/renderers.h"
#include "support/scenes.h"
#include "support/voxels.h"

namespace vct::test {
namespace {

// In voxels: what float positions in a volume of 128 voxels are uncertain by (128 * 2^-23, some operations),
// and a rasterizer that snaps corners to 1/256 of a pixel.
constexpr double marginVoxels = 1.0 / 128.0;

// A sample of the triangle in every voxel said to be touched, and no sample in any other.
TEST(CpuVoxelizer, AgreesWithDenseSamplesOfRandomTriangles) {
    constexpr int grid = 64;  // of which the triangles take 8: few voxels, so samples are dense
    constexpr int samples = 600;
    Volume volume;
    volume.grid = grid;
    volume.side = grid;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> coordinate(20.0F, 28.0F);
    for (int triangle = 0; triangle < 40; ++triangle) {
        Scene scene = emptyScene();
        Mesh mesh;
        for (int i = 0; i < 3; ++i)
            mesh.vertices.push_back(
                {{coordinate(random), coordinate(random), coordinate(random)}, {}, {}, {}});
        mesh.indices = {0, 1, 2};
        scene.instances.push_back({0, glm::dmat4(1.0)});
        scene.meshes.push_back(mesh);
        const auto all = [](const Material&) { return true; };
        const Occupancy touched = occupancyOnCpu(scene, volume, 1e-9, all);
        const double spacing = 14.0 / samples;  // the longest edge, 8 sqrt(3), over the samples along it
        const Occupancy deep = occupancyOnCpu(scene, volume, -spacing, all);
        Occupancy sampled(touched.size(), false);
        const glm::dvec3 a(mesh.vertices[0].position), b(mesh.vertices[1].position),
            c(mesh.vertices[2].position);
        for (int i = 0; i <= samples; ++i)
            for (int j = 0; i + j <= samples; ++j) {
                const glm::dvec3 p = a + (b - a) * (i / double(samples)) + (c - a) * (j / double(samples));
                const glm::ivec3 voxel(glm::floor(p));
                sampled[(static_cast<std::size_t>(voxel.z) * grid + voxel.y) * grid + voxel.x] = true;
            }
        for (std::size_t i = 0; i < touched.size(); ++i) {
            ASSERT_TRUE(!sampled[i] || touched[i]) << "triangle " << triangle << " voxel " << i;
            ASSERT_TRUE(!deep[i] || sampled[i]) << "triangle " << triangle << " voxel " << i;
        }
    }
}

struct Comparison {
    std::size_t touched = 0;   // by any triangle
    std::size_t missed = 0;    // touched by a surface without holes, and empty on the GPU
    std::size_t extra = 0;     // occupied on the GPU, and touched by nothing
    std::size_t farExtra = 0;  // of those, without a touched neighbour
};

bool hasNeighbour(const Occupancy& occupied, int grid, int x, int y, int z) {
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, grid - 1); ++k)
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, grid - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, grid - 1); ++i)
                if (occupied[(static_cast<std::size_t>(k) * grid + j) * grid + i]) return true;
    return false;
}

Comparison compareOccupancy(const Scene& scene, int grid) {
    const Context context = openContext(Backend::egl);
    const Settings settings = smallSettings(grid, 16);
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
    renderer.frame(Mode::gi, frameScene(scene));
    const Words words = readVoxels(renderer.packed()->occupancy().texture(), 0);

    // Holes of an alpha mask are the texture's to say: a masked surface may fill a voxel and need not.
    const auto everything = [](const Material&) { return true; };
    const auto solid = [](const Material& m) { return m.alphaMode == Material::AlphaMode::opaque; };
    const Occupancy may = occupancyOnCpu(scene, renderer.volume(), marginVoxels, everything);
    const Occupancy must = occupancyOnCpu(scene, renderer.volume(), -marginVoxels, solid);
    Comparison result;
    std::size_t index = 0;
    for (int z = 0; z < grid; ++z)
        for (int y = 0; y < grid; ++y)
            for (int x = 0; x < grid; ++x, ++index) {
                result.touched += may[index] ? 1 : 0;
                result.missed += must[index] && words[index] == 0 ? 1 : 0;
                if (words[index] == 0 || may[index]) continue;
                ++result.extra;
                result.farExtra += hasNeighbour(may, grid, x, y, z) ? 0 : 1;
            }
    return result;
}

// The largest share of touched voxels that may be missed: measured, and a few tenths of a per cent of
// head-room. The rasterizer takes one voxel per column, the one at the pixel's centre: what it misses are
// edges, and the second and third voxel of a column where a surface is steep. Scenes of axis-aligned walls
// miss edges only.
double missedBound(const std::string& scene) {
    static const std::map<std::string, double> bounds{
        {"contact", 0.133},  {"cornell", 0.116},   {"cornell_10km", 0.116}, {"cornell_1mm", 0.116},
        {"corridor", 0.095}, {"courtyard", 0.066}, {"furnace", 0.010},      {"lamp", 0.058},
        {"lone_plane", 0.0}, {"thin_wall", 0.030}};
    const auto bound = bounds.find(scene);
    return bound != bounds.end() ? bound->second : 0.15;
}

class OccupancyOf : public testing::TestWithParam<std::string> {};
std::vector<std::string> sceneFiles() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(VCT_SOURCE_DIR "/assets"))
        if (entry.path().extension() == ".glb") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}
INSTANTIATE_TEST_SUITE_P(Scenes, OccupancyOf, testing::ValuesIn(sceneFiles()),
                         [](const auto& test) { return test.param; });

TEST_P(OccupancyOf, EqualsTheExactOverlapButForMissedVoxels) {
    const Scene scene = loadGltf(asset(GetParam() + ".glb"));
    for (int grid : {64, 128}) {
        const Comparison c = compareOccupancy(scene, grid);
        const double missedShare = static_cast<double>(c.missed) / static_cast<double>(c.touched);
        std::printf("%s %d^3: touched %zu, missed %zu (%.2f %%), extra %zu, further than a voxel %zu\n",
                    GetParam().c_str(), grid, c.touched, c.missed, 100.0 * missedShare, c.extra, c.farExtra);
        EXPECT_EQ(c.farExtra, 0U);
        EXPECT_LE(static_cast<double>(c.extra), 1e-4 * static_cast<double>(c.touched));
        EXPECT_LE(missedShare, missedBound(GetParam()));
    }
}

}  // namespace
}  // namespace vct::test
