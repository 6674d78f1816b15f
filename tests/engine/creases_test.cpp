// Creases between walls without thickness. A shadow map's bias and filter let the sun in there, into the hard
// shadow, the soft shadow and the voxels. In a room whose walls are the planes of a cube, the sun comes in
// through the missing wall alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

// The inside is a cube of side 2 around the origin.
struct CubeRoom {
    const char* name;
    bool open;         // without the wall at +z
    double thickness;  // of walls that are boxes; 0: the walls are rectangles with their front inside
    bool doubleSided;
    double angleDeg;  // turns everything around an oblique axis
};
const CubeRoom cubeRooms[] = {{"closed", false, 0.0, false, 25.0},
                              {"closed, thin walls", false, 0.04, false, 0.0},
                              {"closed, double-sided", false, 0.0, true, 0.0},
                              {"open", true, 0.0, false, 0.0},
                              {"open, double-sided, turned", true, 0.0, true, 25.0},
                              {"open, thin walls", true, 0.04, false, 0.0}};

// Directions to the sun: through the front, nearly along a wall, two that let walls and floor shade each
// other, two that are parallel to a wall, which the shadow map then does not show, and four in the cube that
// are a degree above a wall, of which the map shows its foot.
const glm::dvec3 suns[] = {{0.3, 0.5, 0.8},     {0.8, 0.5, 0.1},       {-0.63, 0.72, 0.2},
                           {0.23, -0.75, 0.62}, {-0.988, 0.0, -0.154}, {-0.954, -0.299, -0.008}};
const glm::dvec3 sunsOfFeet[] = {
    {0.497, 0.02, 0.867}, {-0.953, -0.02, -0.304}, {0.02, 0.29, 0.957}, {0.018, 0.685, 0.728}};

// `turn` is set to the matrix from the cube to the world.
Scene sceneOf(const CubeRoom& room, glm::dmat4& turn) {
    Scene scene = room.thickness > 0.0 ? emptyScene() : closedBox(0.0);
    scene.materials.front().doubleSided = room.doubleSided;
    if (room.thickness > 0.0)
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                glm::dvec3 sides(2.0 + 2.0 * room.thickness), centre(0.0);
                sides[axis] = room.thickness;
                centre[axis] = side * (1.0 + 0.5 * room.thickness);
                addBox(scene, sides, centre);
            }
    if (room.open) scene.instances.pop_back();  // the last one in either form
    turn = turnScene(scene, room.angleDeg);
    return finished(std::move(scene));
}

constexpr float leak = 0.02F;
// Share of the dark pixels in creases. Of a wall that is parallel to the sun the map has a few texels or
// none.
constexpr double softLeaks = 0.0005;
constexpr float sunDeg = 2.0F;

struct Count {
    int dark = 0,
        leaks = 0;          // pixels without sun within 4 pixels of a crease; pixels without sun that are lit
    int lit = 0, lost = 0;  // pixels in the sun; those that are less than half lit
};

constexpr int mapSide = 512;

class Creases : public testing::Test {
  protected:
    Count countOf(const CubeRoom& room, bool soft) const {
        glm::dmat4 turn;
        const Scene scene = sceneOf(room, turn);
        const glm::dvec3 eye(-0.2, 0.1, room.open ? 2.3 : 0.94);
        Camera camera = lookAt(eye, {0.1, -0.05, -1.0}, room.open ? 62 : 85);
        camera.worldFromCamera = turn * camera.worldFromCamera;
        Settings settings = presetSettings("mobile");
        settings.size = {200, 200};
        settings.shadowMapSize = mapSide;
        settings.shadowConeAngleDeg = sunDeg;
        settings.grid = 64;
        settings.lightFrames = 1;  // the indirect light is subtracted
        FrameInspector frame(context_, scene, lightFrom({0, 1, 0}), settings, camera);
        const double texel =  // of the map, or less
            glm::length(scene.boundsWorld.max - scene.boundsWorld.min) / mapSide;
        const double pixel = 2.0 * std::tan(0.5 * camera.verticalFovRad) / settings.size.y;
        const glm::dmat3 cubeFromWorld = glm::transpose(glm::dmat3(turn));
        const double discRad = soft ? glm::radians(0.5 * sunDeg) : 0.0;
        Count count;
        std::vector<glm::dvec3> directions(std::begin(suns), std::end(suns));
        for (const glm::dvec3& sun : sunsOfFeet)
            directions.push_back(glm::dmat3(turn) * sun);
        for (const glm::dvec3& sun : directions) {
            frame.setLight(sun);
            const glm::dvec3 directionToLight = cubeFromWorld * glm::normalize(sun);
            const std::vector<float> light = soft ? frame.softShadow() : frame.hardShadow();
            for (std::size_t i = 0; i < light.size(); ++i) {
                if (!frame.pixels()[i].surface) continue;
                const glm::dvec3 p = cubeFromWorld * frame.pixels()[i].positionWorld;
                const glm::dvec3 normal = cubeFromWorld * frame.pixels()[i].normal;
                // n.l accounts for a sun that is partly below the surface's horizon.
                if (glm::dot(normal, directionToLight) < std::sin(discRad) + 0.05) continue;
                glm::dvec3 toWalls = glm::abs(1.0 - glm::abs(p));
                std::sort(&toWalls.x, &toWalls.x + 3);  // the nearest wall is the pixel's own
                const double near = 4.0 * pixel * glm::length(p - eye);
                // The rasterizer rounds corners, so either wall may be seen this near to a crease. Walls with
                // a thickness have narrow sides, too.
                if (toWalls[0] > 1e-3 || toWalls[1] < near / 80.0 || glm::dot(normal, p) > 0.0) continue;
                const double outside = outsideOfTheOpening(p, directionToLight, room.open);
                // The filter's reach and the sun's size.
                const double border =
                    2.0 * (6.0 * texel + 4.0 * discRad) / std::max(std::abs(directionToLight.z), 1e-3);
                if (outside > border) {
                    count.dark += toWalls[1] < near;
                    count.leaks += light[i] > leak;
                } else if (outside < -border) {
                    ++count.lit;
                    count.lost += light[i] < 0.5F;
                }
            }
        }
        return count;
    }

  private:
    // Distance between the missing wall and the point where a ray leaves the cube; negative where the ray
    // leaves through that wall.
    static double outsideOfTheOpening(const glm::dvec3& p, const glm::dvec3& directionToLight, bool open) {
        if (!open || directionToLight.z <= 0.0) return 1e9;
        const glm::dvec3 leaves = p + (1.0 - p.z) / directionToLight.z * directionToLight;
        return std::max(std::abs(leaves.x), std::abs(leaves.y)) - 1.0;
    }
    const Context context_ = openContext(Backend::egl);
};

TEST_F(Creases, AreDarkWhereNoSunReaches) {
    for (const bool soft : {false, true}) {
        Count all;
        for (const CubeRoom& room : cubeRooms) {
            const Count count = countOf(room, soft);
            EXPECT_GT(count.dark, 100) << room.name;
            all.dark += count.dark;
            all.leaks += count.leaks;
            all.lit += count.lit;
            all.lost += count.lost;
        }
        EXPECT_GT(all.lit, 10000);
        EXPECT_LE(all.leaks, soft ? softLeaks * all.dark : 0.0) << (soft ? "soft" : "hard");
        EXPECT_LE(all.lost, 0.001 * all.lit) << (soft ? "soft" : "hard");
    }
}

// No face towards the inside of a closed room holds sunlight. In the turned room all faces are towards the
// inside.
TEST(CreasesOfVoxels, HoldNoSun) {
    const Context context = openContext(Backend::egl);
    for (const CubeRoom& room : cubeRooms) {
        if (room.open) continue;
        glm::dmat4 turn;
        const Scene scene = sceneOf(room, turn);
        Settings settings = presetSettings("mobile");
        settings.size = {16, 16};
        settings.revoxelize = true;
        FrameInspector frame(context, scene, lightFrom({0, 1, 0}), settings,
                             lookAt({0, 0, 0}, {0, 0, -1}, 90));
        for (const glm::dvec3& sun : suns) {
            frame.setLight(sun);
            int faces = 0, lit = 0;
            for (const auto& [entry, value] : frame.faces()) {
                const glm::dvec3 fromMiddle =
                    glm::dvec3(shared::unpackFaceVoxel(entry)) + 0.5 - 0.5 * settings.grid;
                const int face = static_cast<int>(shared::unpackFace(entry));
                if (room.angleDeg == 0.0 && glm::dot(fromMiddle, faceDirection(face)) > 0.0) continue;
                ++faces;
                lit += std::max({value.radiance.r, value.radiance.g, value.radiance.b}) > 2.0 / 255.0 ? 1 : 0;
            }
            EXPECT_GT(faces, 1000) << room.name;
            // Walls of a turned room that meet share faces, whose middle may lie beyond a wall.
            EXPECT_LE(lit, room.angleDeg == 0.0 ? 0 : faces / 800) << room.name;
        }
    }
}

}  // namespace
}  // namespace vct::test
