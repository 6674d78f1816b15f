// The look-up of irradiance in nested cubes of voxels: in each of them, and across their borders.
#include <algorithm>
#include <cmath>
#include <random>

#include "api/looked_up.h"
#include "engine/cascades.h"
#include "engine/frame_uniforms.h"
#include "engine/volume.h"

namespace vct::test {
namespace {

// The camera is 4 m from one end of the hall. The finest of three cascades reaches to about x = 7 m, the next
// one to about 12 m.
class CascadesLookUp : public ::testing::Test {
  protected:
    void expectThePicture();
    void expectNoStepAtABorder();

    static constexpr int grid = 64, cascades = 3;

    CascadesLookUp() {
        Options options;
        options.voxelSize = static_cast<float>(1.01 * volume_.voxelSize() / (1 << (cascades - 1)));
        options.width = width;
        options.height = height;
        options.irradiance = true;
        light_.emplace(getProcAddress, hall_.scene, options);
        // Both show the same faces, whose light need not be refined.
        Pictures pictures;
        for (int frame = 0; frame < 20; ++frame)
            pictures = light_->render(hall_.view(camera_), GlobalIllumination::Light::oneStep);
        picture_ = imageOf(pictures.irradiance);
    }

    std::unique_ptr<Platform> context_ = createContext(Backend::egl, false);
    DescribedScene hall_{hall()};
    Volume volume_ = volumeAround(hall_.loaded.boundsWorld, grid);
    Camera camera_ = lookAt({4, 1.7, 4}, {5, 1.6, 4.1}, 75);
    std::optional<GlobalIllumination> light_;
    Image picture_;  // irradiance
};

// The point where the ray through a pixel leaves the hall.
struct Hit {
    glm::dvec3 position, normal;
    bool isNearEdge;
};
Hit hitAt(const glm::dmat4& worldFromClip, const glm::dvec3& eye, int x, int y) {
    const glm::dvec4 far =
        worldFromClip * glm::dvec4(2.0 * (x + 0.5) / width - 1.0, 1.0 - 2.0 * (y + 0.5) / height, 1.0, 1.0);
    const glm::dvec3 direction = glm::dvec3(far) / far.w - eye, sides(24, 6, 8);
    double nearest = HUGE_VAL;
    Hit hit{};
    for (int axis = 0; axis < 3; ++axis) {
        const double away = ((direction[axis] > 0 ? sides[axis] : 0.0) - eye[axis]) / direction[axis];
        if (!(away < nearest)) continue;
        nearest = away;
        hit.normal = glm::dvec3(0.0);
        hit.normal[axis] = direction[axis] > 0 ? -1.0 : 1.0;
    }
    hit.position = eye + nearest * direction;
    int near = 0;
    for (int axis = 0; axis < 3; ++axis)
        near += std::min(hit.position[axis], sides[axis] - hit.position[axis]) < 0.5;
    hit.isNearEdge = near > 1;
    return hit;
}

// A wall's edge takes the light of cones in one, and of the nearest faces in the other.
void CascadesLookUp::expectThePicture() {
    const glm::dmat4 worldFromClip =
        glm::inverse(clipFromWorld(camera_, hall_.loaded.boundsWorld, double{width} / height));
    Image points(2, width * height);
    std::vector<float> expected;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Hit hit = hitAt(worldFromClip, glm::dvec3(camera_.worldFromCamera[3]), x, y);
            const bool mayBePanel = hit.normal.y < 0.0;
            if (mayBePanel || hit.isNearEdge) continue;
            const int i = static_cast<int>(expected.size());
            points.at(0, i) = hit.position;
            points.at(1, i) = hit.normal;
            expected.push_back(picture_.at(x, y).x);
        }
    points.height = static_cast<int>(expected.size());
    ASSERT_GT(points.height, 5000);
    const std::vector<glm::vec3> found = lookedUp(*light_, points);
    double sum = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double difference = std::abs(found[i].x / expected[i] - 1.0F);
        sum += difference;
        largest = std::max(largest, difference);
    }
    EXPECT_LE(sum / points.height, 0.002);
    EXPECT_LE(largest, 0.005);
}

// Points 1 mm apart, on both sides of the position from which on a cascade is not used, 1 voxel before its
// border. Light by cones changes a little more from point to point than light of surfaces.
void CascadesLookUp::expectNoStepAtABorder() {
    constexpr int pairs = 300;
    Cascades nested(cascades, grid);
    nested.follow(eyeInVolume(camera_, volume_));
    std::mt19937 random;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const char* place : {"floor", "wall", "air"})
        for (int cascade = 0; cascade + 1 < cascades; ++cascade) {
            const double side = nested.side(cascade), end = nested.corner(cascade).x + side - side / grid;
            Image points(2, 2 * pairs);
            for (int i = 0; i < pairs; ++i) {
                glm::dvec3 position(volume_.minWorld.x + volume_.side * end, 0.5 + 4.0 * uniform(random),
                                    1.5 + 5.0 * uniform(random));
                glm::dvec3 normal(0.0);
                if (*place == 'f') {
                    position.y = 0.0;
                    normal.y = 1.0;
                } else if (*place == 'w') {
                    position.z = 0.0;
                    normal.z = 1.0;
                } else {
                    for (int axis = 0; axis < 3; ++axis)
                        normal[axis] = uniform(random) - 0.5;
                    normal = glm::normalize(normal);
                }
                for (const int k : {0, 1}) {
                    points.at(0, 2 * i + k) = position + glm::dvec3(0.001 * (k - 0.5), 0.0, 0.0);
                    points.at(1, 2 * i + k) = normal;
                }
            }
            const std::vector<glm::vec3> found = lookedUp(*light_, points);
            double squares = 0.0;
            for (std::size_t i = 0; i < found.size(); i += 2)
                squares += std::pow(found[i + 1].x / found[i].x - 1.0F, 2.0);
            EXPECT_LE(std::sqrt(squares / pairs), *place == 'a' ? 0.005 : 0.001)
                << place << ", cascade " << cascade;
        }
}

// One test, because the light of the hall takes long.
TEST_F(CascadesLookUp, AgreesWithThePictureAndHasNoStepAtABorder) {
    expectThePicture();
    expectNoStepAtABorder();
}

}  // namespace
}  // namespace vct::test
