// What should not matter and does a little: where the grid lies, and how the scene is turned in it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

// Of a scene file, turned by `angleDeg` together with its light and its camera, so that the picture is the
// same and its alignment to the voxels is not; around them a volume with room for every turn, moved by
// `shiftVoxels` along its diagonal.
Image firstBounce(const Context& context, const std::string& file, const Settings& settings,
                  double shiftVoxels, double angleDeg) {
    Scene scene = loadGltf(asset(file + ".glb"));
    DirectionalLight light = chooseLight(scene);
    Camera camera = chooseCamera(scene, "");
    const Volume tight = volumeAround(scene.boundsWorld, settings.grid);
    const glm::dvec3 centre = tight.minWorld + 0.5 * tight.side;
    const glm::dmat4 turn = glm::translate(
        glm::rotate(glm::translate(glm::dmat4(1.0), centre), glm::radians(angleDeg), {0, 1, 0}), -centre);
    for (Instance& instance : scene.instances)
        instance.worldFromObject = turn * instance.worldFromObject;
    light.towardsLight = glm::dvec3(turn * glm::dvec4(light.towardsLight, 0.0));
    camera.worldFromCamera = turn * camera.worldFromCamera;
    const glm::dvec3 shifted = centre + shiftVoxels * 1.5 * tight.voxelSize();
    const double half = 0.75 * tight.side * (settings.grid - 5.0) / settings.grid;
    scene.boundsWorld = {shifted - half, shifted + half};
    return FrameInspector(context, scene, light, settings, camera).view(VCT_VIEW_INDIRECT);
}

struct Change {
    double mean;  // of the changed picture over the other's, minus 1
    double rms;   // of the difference, over the other's mean
};
Change changeOf(const Image& reference, const Image& other) {
    double sum = 0.0, otherSum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < reference.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double difference = other.pixels[i][c] - reference.pixels[i][c];
            sum += reference.pixels[i][c];
            otherSum += other.pixels[i][c];
            squares += difference * difference;
        }
    const double count = 3.0 * static_cast<double>(reference.pixels.size());
    return {otherSum / sum - 1.0, std::sqrt(squares / count) / (sum / count)};
}

// Measured changes, with head-room; they are no merit. Coarse packed voxels are read from the second sample
// on, and half a voxel or a turn fills other ones; most of the courtyard's change is around its lanterns,
// small and bright.
struct Stated {
    const char* preset;
    const char* scene;
    double mean;             // of either change
    double halfVoxel, turn;  // RMS
};
class Stability : public testing::TestWithParam<Stated> {};
INSTANTIATE_TEST_SUITE_P(Presets, Stability,
                         testing::Values(Stated{"thesis", "cornell", 0.05, 0.28, 0.48},
                                         Stated{"thesis", "courtyard", 0.08, 0.62, 0.50},
                                         Stated{"mobile", "cornell", 0.05, 0.17, 0.23},
                                         Stated{"mobile", "courtyard", 0.2, 1.3, 1.3}),
                         [](const auto& test) {
                             return std::string(test.param.preset) + "_" + test.param.scene;
                         });

TEST_P(Stability, HalfAVoxelAndATurnChangeNoMoreThanMeasured) {
    const Stated stated = GetParam();
    const Context context = openContext(Backend::egl);
    Settings settings = presetSettings(stated.preset);
    const bool thesis = settings.voxels == Voxels::packed;
    if (thesis) settings.grid = 128;
    settings.size = glm::ivec2(thesis ? 96 : 384);  // the faces' pixels are finer than the grid there
    settings.shadowMapSize = 384;
    // A quarter off, because walls would lie exactly between two voxels otherwise, where rounding decides.
    const Image reference = firstBounce(context, stated.scene, settings, 0.25, 0.0);
    const auto expectWithin = [&](const char* what, const Image& other, double allowed) {
        const Change change = changeOf(reference, other);
        std::printf("%s, %s, %s: mean %+.2f %%, RMS %.1f %%\n", stated.preset, stated.scene, what,
                    100.0 * change.mean, 100.0 * change.rms);
        EXPECT_LE(std::abs(change.mean), stated.mean) << what;
        EXPECT_LE(change.rms, allowed) << what;
        EXPECT_GT(change.rms, 0.0) << what << ": nothing was moved";
    };
    expectWithin("grid moved by half a voxel", firstBounce(context, stated.scene, settings, 0.75, 0.0),
                 stated.halfVoxel);
    expectWithin("scene turned by 45 degrees", firstBounce(context, stated.scene, settings, 0.25, 45.0),
                 stated.turn);
}

}  // namespace
}  // namespace vct::test
