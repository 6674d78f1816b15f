// Where two walls without thickness meet, a shadow map's bias and its filter let the sun in that no ray from
// there can reach: in the picture by the hard and the soft shadow, and in the voxels as light.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/exact_light.h"
#include "support/frame_inspector.h"
#include "support/rooms.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

const std::vector<Room>& testRooms() {
    static const std::vector<Room> rooms{
        makeRoom(Opening::none, 0.0, false, 25.0), makeRoom(Opening::front, 0.0, false, 0.0),
        makeRoom(Opening::front, 0.0, true, 25.0), makeRoom(Opening::window, 0.0, false, 25.0),
        makeRoom(Opening::window, 0.04, false, 0.0)};
    return rooms;
}

// In through the front, along a wall nearly, and from where walls and floor shade each other.
const std::vector<glm::dvec3>& suns() {
    static const std::vector<glm::dvec3> towards{
        {0.3, 0.5, 0.8}, {0.8, 0.5, 0.1}, {-0.63, 0.72, 0.2}, {0.23, -0.75, 0.62}};
    return towards;
}

// What rays say of a point and of all around it, as far as the filter reaches.
enum class Around { dark, mixed, lit };

// `discRad`: the sun's radius.
Around around(const ExactLight& exact, const glm::dvec3& position, int triangle, const glm::dvec3& normal,
              const glm::dvec3& towardsLight, double reach, double discRad) {
    const glm::dvec3 helper = std::abs(towardsLight.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(towardsLight, helper));
    const glm::dvec3 v = glm::cross(towardsLight, u);
    const double goldenAngle = 2.399963;
    bool seen = false, unseen = false;
    for (int i = 0; i < 16; ++i) {
        // Nearly the whole disc, first its middle.
        const double radius = std::sqrt(i / 15.0), angle = i * goldenAngle;
        const glm::dvec3 aside = radius * (std::cos(angle) * u + std::sin(angle) * v);
        const glm::dvec3 beside = position + reach * aside;
        const glm::dvec3 point =
            beside - glm::dot(beside - position, normal) / glm::dot(towardsLight, normal) * towardsLight;
        // Of another wall that is lit there, the filter mixes in some.
        seen = seen || exact.litNeighbour(position, beside, towardsLight, 4.0 * reach);
        if (!exact.covered(point, triangle)) continue;
        for (int j = 0; j < (discRad > 0.0 ? 9 : 1); ++j) {
            const double turn = (i + j) * goldenAngle;
            const double sine = j == 0 ? 0.0 : discRad;
            const glm::dvec3 ray =
                glm::normalize(towardsLight + sine * (std::cos(turn) * u + std::sin(turn) * v));
            (exact.sees(point, triangle, ray) ? seen : unseen) = true;
        }
    }
    return seen && unseen ? Around::mixed : seen ? Around::lit : Around::dark;
}

// A map knows a wide penumbra in a crease by 16 samples, of which three may go astray.
constexpr float hardLeak = 0.02F, softLeak = 0.2F;
// Share of the dark pixels in creases. The soft shadow can't afford the hard one's look at the texel beyond
// the four.
constexpr double softLeaks = 0.001;

struct Count {
    int dark = 0, leaks = 0;  // within 4 pixels of a crease, where no sun is: dark, and lit
    int lit = 0, lost = 0;    // where nothing is in shadow; of these less than half lit
    void operator+=(const Count& other) {
        dark += other.dark;
        leaks += other.leaks;
        lit += other.lit;
        lost += other.lost;
    }
};

class CreasesOfARoom {
  public:
    CreasesOfARoom(const Context& context, const Room& room, const glm::ivec2& size, int mapSize)
        : exact_(room.scene),
          frame_(context, room.scene, lightFrom({0, 1, 0}), settings(size, mapSize), room.camera) {
        const glm::dvec3 extent = room.scene.boundsWorld.max - room.scene.boundsWorld.min;
        texel_ = glm::length(extent) / mapSize;  // or less
        const glm::dvec3 eye(room.camera.worldFromCamera[3]);
        const double pixel = 2.0 * std::tan(0.5 * room.camera.verticalFovRad) / size.y;
        for (std::size_t i = 0; i < frame_.pixels().size(); ++i) {
            const SurfacePixel& pixelOf = frame_.pixels()[i];
            if (!pixelOf.surface) continue;
            const int triangle = exact_.triangleAt(pixelOf.positionWorld, pixelOf.normal);
            if (triangle < 0) continue;
            const glm::dvec3 p = exact_.onPlane(pixelOf.positionWorld, triangle);
            const double near = 4.0 * pixel * glm::length(p - eye);
            const double distance = exact_.distanceToOthers(p, triangle, near);
            // A rasterizer's corners are rounded: this near to the crease either wall may be seen.
            if (distance < near / 80.0) continue;
            points_.push_back({i, triangle, p, pixelOf.normal, distance < near});
        }
    }

    Count count(const glm::dvec3& towardsLight, bool soft) {
        const glm::dvec3 towards = glm::normalize(towardsLight);
        const double discRad = soft ? glm::radians(0.5 * sunDeg) : 0.0;
        frame_.setLight(towards);
        const std::vector<float> light = soft ? frame_.softShadow() : frame_.hardShadow();
        Count count;
        for (const Point& point : points_) {
            // A sun partly below the surface's horizon is left to n.l; and from within 3 degrees of it the
            // map has no texels of a post's side.
            if (glm::dot(point.normal, towards) < std::sin(discRad) + 0.05) continue;
            const float found = light[point.pixel];
            const bool leak = found > (soft ? softLeak : hardLeak), loss = found < 0.5F;
            const bool seen = exact_.sees(point.position, point.triangle, towards);
            if (!seen && !leak) count.dark += point.nearCrease;
            // Where it may be wrong; and of the lit ones one in eight, to know how many there are.
            if (seen ? !loss && point.pixel % 8 != 0 : !leak || !point.nearCrease) continue;
            const Around truth =
                around(exact_, point.position, point.triangle, point.normal, towards, 1.5 * texel_, discRad);
            if (!seen)
                count.leaks += truth == Around::dark;
            else if (truth == Around::lit) {
                count.lit += point.pixel % 8 == 0 ? 8 : 0;
                count.lost += loss;
            }
        }
        return count;
    }

  private:
    static constexpr float sunDeg = 2.0F;
    static Settings settings(const glm::ivec2& size, int mapSize) {
        Settings settings = presetSettings("mobile");
        settings.size = size;
        settings.shadowMapSize = mapSize;
        settings.shadowConeAngleDeg = sunDeg;
        settings.grid = 64;
        settings.lightFrames = 1;  // what surfaces receive is taken off again
        return settings;
    }
    struct Point {
        std::size_t pixel;
        int triangle;
        glm::dvec3 position, normal;
        bool nearCrease;
    };
    ExactLight exact_;
    FrameInspector frame_;
    double texel_;  // of the map, in the world
    std::vector<Point> points_;
};

void print(const Count& count, const std::string& what) {
    std::printf("  %-32s %7d dark pixels in creases, %d lit; %7d lit pixels, %d dark\n", what.c_str(),
                count.dark, count.leaks, count.lit, count.lost);
}

struct Sizes {
    glm::ivec2 picture;
    int map;
};
class Creases : public testing::TestWithParam<Sizes> {};
INSTANTIATE_TEST_SUITE_P(Sizes, Creases, testing::Values(Sizes{{320, 180}, 1024}, Sizes{{200, 200}, 512}),
                         [](const auto& test) { return "Map" + std::to_string(test.param.map); });

TEST_P(Creases, AreDarkWhereNoSunReaches) {
    const Context context = openContext(Backend::egl);
    for (const bool soft : {false, true}) {
        Count all;
        for (const Room& room : testRooms()) {
            CreasesOfARoom creases(context, room, GetParam().picture, GetParam().map);
            Count count;
            for (const glm::dvec3& sun : suns())
                count += creases.count(sun, soft);
            print(count, room.name + (soft ? ", soft" : ", hard"));
            EXPECT_GT(count.dark, 100);
            all += count;
        }
        EXPECT_LE(all.leaks, soft ? softLeaks * all.dark : 0.0) << (soft ? "soft" : "hard");
        EXPECT_LE(all.lost, 0.001 * all.lit) << (soft ? "soft" : "hard");
    }
}

// Faces of the voxels that hold the sun's light, though no point near them sees it.
int facesLitInVain(FrameInspector& frame, const ExactLight& exact, const glm::dvec3& towardsLight) {
    const Volume& volume = frame.renderer().volume();
    const FaceLevel level = frame.faceLevels().front();
    const int side = level.side();
    std::vector<bool> lit(static_cast<std::size_t>(side) * side * side * faceCount);
    const auto index = [&](const glm::ivec3& v, int face) {
        return ((static_cast<std::size_t>(v.z) * side + v.y) * side + v.x) * faceCount + face;
    };
    for (std::size_t t = 0; t < exact.triangles().size(); ++t) {
        const ExactLight::Triangle& triangle = exact.triangles()[t];
        const double facing = glm::dot(triangle.normal, towardsLight);
        if (facing <= 0.0 && !triangle.doubleSided) continue;
        const glm::dvec3 normal = facing > 0.0 ? triangle.normal : -triangle.normal;
        const double longest =
            std::max({glm::length(triangle.b - triangle.a), glm::length(triangle.c - triangle.a),
                      glm::length(triangle.c - triangle.b)});
        const int steps = static_cast<int>(std::ceil(2.0 * longest / volume.voxelSize()));
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j) {
                const glm::dvec3 p = triangle.a + (triangle.b - triangle.a) * (double(i) / steps) +
                                     (triangle.c - triangle.a) * (double(j) / steps);
                if (!exact.sees(p, static_cast<int>(t), towardsLight)) continue;
                const glm::ivec3 voxel(glm::floor((p - volume.minWorld) / volume.voxelSize()));
                for (int n = 0; n < 27; ++n)
                    for (int face = 0; face < faceCount; ++face)
                        // The filter mixes in some light of a lit wall next to it; but not through a wall.
                        if (!triangle.doubleSided || glm::dot(faceDirection(face), normal) > 0.0)
                            lit[index(voxel + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1, face)] = true;
            }
    }
    int inVain = 0;
    level.forEachVoxel([&](const glm::ivec3& voxel) {
        for (int face = 0; face < faceCount; ++face) {
            const glm::u8vec4& value = level.at(voxel, face);
            inVain += std::max({value.r, value.g, value.b}) > 1 && !lit[index(voxel, face)];
        }
    });
    return inVain;
}

TEST(CreasesOfVoxels, HoldNoSun) {
    const Context context = openContext(Backend::egl);
    for (const Room& room : testRooms()) {
        const ExactLight exact(room.scene);
        Settings settings = presetSettings("mobile");
        settings.size = {16, 16};
        int inVain = 0;
        FrameInspector frame(context, room.scene, lightFrom({0, 1, 0}), settings, room.camera);
        for (const glm::dvec3& sun : suns()) {
            frame.setLight(sun);
            inVain += facesLitInVain(frame, exact, glm::normalize(sun));
        }
        std::printf("  %-32s %d faces lit in vain\n", room.name.c_str(), inVain);
        EXPECT_EQ(inVain, 0) << room.name;
    }
}

}  // namespace
}  // namespace vct::test
