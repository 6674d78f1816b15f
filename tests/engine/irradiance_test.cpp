// The irradiance of directional voxels, compared with closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr int pictureSide = 128;

// Adds a material that emits radiance 1, and returns its index.
int addEmitter(Scene& scene) {
    Material emitter = scene.materials[0];
    emitter.emissive = glm::vec3(1.0F);
    scene.materials.push_back(emitter);
    return static_cast<int>(scene.materials.size()) - 1;
}

// Bounds on errors are the measured errors of the preset and about a hundredth more.

TEST(Gather, ALonePlaneSeesTheSkyAndNothingElse) {
    const Context context = openContext(Backend::egl);
    // One step has no history, so its weight is 1.
    for (const auto& [sky, lightFrames] : {std::pair{0.0F, 16}, {0.75F, 16}, {0.75F, 1}}) {
        Settings settings = mobileAt(40);
        settings.lightFrames = lightFrames;
        settings.skyRadiance = glm::vec3(sky);
        FrameInspector frame(context, lonePlane(0.0), noLight(), settings,
                             lookAt({0, 3, 0.5}, {0, 0, 0}, 40));
        const Spread light = frame.spreadOf(Output::indirectLight),
                     ambientVisibility = frame.spreadOf(Output::ambientVisibility);
        ASSERT_GT(light.count, 800);
        EXPECT_NEAR(light.min, sky, sky * std::exp2(-10));  // halves
        EXPECT_NEAR(light.max, sky, sky * std::exp2(-10));
        EXPECT_GE(ambientVisibility.min, 0.999);
        EXPECT_EQ(ambientVisibility.max, 1.0);
    }
}

// Share of the cosine-weighted hemisphere around `n` that a polygon above the horizon fills (Lambert 1760).
double formFactor(const std::vector<glm::dvec3>& polygon, const glm::dvec3& p, const glm::dvec3& n) {
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = glm::normalize(polygon[i] - p);
        const glm::dvec3 b = glm::normalize(polygon[(i + 1) % polygon.size()] - p);
        const glm::dvec3 edge = glm::cross(a, b);
        if (glm::length(edge) > 1e-12)
            sum += std::acos(glm::clamp(glm::dot(a, b), -1.0, 1.0)) * glm::dot(glm::normalize(edge), n);
    }
    return std::abs(sum) / (2.0 * pi);
}

// The error of a picture, relative to the mean of the right values.
struct Deviation {
    double bias = 0.0, rms = 0.0;
};
// `truth` returns the right value at a position, or a negative one to leave the pixel out.
template <class Truth>
Deviation deviationOf(FrameInspector& frame, const Truth& truth) {
    double sum = 0.0, truthSum = 0.0, squares = 0.0;
    int count = 0;
    for (const auto& [surface, light] : frame.seen(Output::indirectLight)) {
        const double right = truth(surface.positionWorld);
        if (right < 0.0) continue;
        sum += light.x;
        truthSum += right;
        squares += (light.x - right) * (light.x - right);
        ++count;
    }
    EXPECT_GT(count, 500);
    return {sum / truthSum - 1.0, std::sqrt(squares / count) / (truthSum / count)};
}

struct Emitter {
    const char* name;
    glm::dvec3 corner, u, v;
    Deviation bound;
    double turnDeg;
};
const Emitter emitters[] = {{"ceiling", {-1, 1.0, -1}, {2, 0, 0}, {0, 0, 2}, {0.035, 0.055}, 30.0},
                            {"patch", {-0.2, 0.7, -0.2}, {0.4, 0, 0}, {0, 0, 0.4}, {0.013, 0.017}, 0.0},
                            {"wall", {-1, 0, -1}, {0, 1, 0}, {0, 0, 2}, {0.01, 0.15}, 0.0}};

TEST(Gather, AFloorReceivesTheFormFactorOfAnEmitter) {
    const Context context = openContext(Backend::egl);
    for (const Emitter& e : emitters) {
        Scene scene = emptyScene();
        addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
        addQuad(scene, e.corner, e.u, e.v, addEmitter(scene));
        const glm::dmat4 turn = turnScene(scene, e.turnDeg);
        scene = finished(std::move(scene));
        Settings settings = mobileAt(64);
        settings.gather.refinedDirections = 256;
        settings.gather.rays = 64;
        const glm::dvec3 eye(turn * glm::dvec4(0, 3, 0.001, 1));
        FrameInspector frame(context, scene, noLight(), settings, lookAt(eye, {0, 0, 0}, 36));
        const Deviation error = deviationOf(frame, [&](const glm::dvec3& positionWorld) {
            const glm::dvec3 p(glm::inverse(turn) * glm::dvec4(positionWorld, 1.0));
            if (std::abs(p.y) > 1e-3) return -1.0;
            return formFactor({e.corner, e.corner + e.u, e.corner + e.u + e.v, e.corner + e.v}, p, {0, 1, 0});
        });
        EXPECT_LE(std::abs(error.bias), e.bound.bias) << e.name;
        EXPECT_LE(error.rms, e.bound.rms) << e.name;
    }
}

// Beside a black wall, under a sky of radiance 1.
TEST(Gather, AFloorBesideABlackWallSeesTheRestOfTheSky) {
    const Context context = openContext(Backend::egl);
    Settings settings = mobileAt(pictureSide);
    settings.skyRadiance = glm::vec3(1.0F);
    Scene scene = emptyScene();
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].baseColor = glm::vec4(0, 0, 0, 1);
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {1, 0, 0});
    addQuad(scene, {0, 0, -1}, {0, 0, 2}, {0, 1, 0}, 1);
    scene = finished(std::move(scene));
    const double voxel = volumeAround(scene.boundsWorld, settings.grid).voxelSize();
    FrameInspector frame(context, scene, noLight(), settings, lookAt({-1, 3, 0.001}, {-0.5, 0, 0}, 36));
    const Deviation error = deviationOf(frame, [&](const glm::dvec3& p) {
        if (p.y > 1e-3 || p.x > -voxel) return -1.0;
        return 1.0 - formFactor({{0, 0, -1}, {0, 1, -1}, {0, 1, 1}, {0, 0, 1}}, p, {0, 1, 0});
    });
    EXPECT_LE(std::abs(error.bias), 0.002);
    EXPECT_LE(error.rms, 0.02);
}

// A ball without light of its own, which touches a floor at the origin: of the sphere's hemisphere above a
// point at the distance x the ball fills R^3 / (x^2 + R^2)^1.5. Rays of the faces around the contact must
// not start inside of the ball.
TEST(Gather, AFloorUnderABallIsDarkAroundTheContact) {
    const Context context = openContext(Backend::egl);
    constexpr double radius = 0.25;
    Scene scene = emptyScene();
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].baseColor = glm::vec4(0, 0, 0, 1);
    addQuad(scene, {-0.5, 0, -0.5}, {0, 0, 1}, {1, 0, 0});
    addBall(scene, radius, {0, radius, 0}, 1);
    scene = finished(std::move(scene));
    scene.boundsWorld = {glm::dvec3(-1.0), glm::dvec3(1.0)};
    Settings settings = mobileAt(2 * pictureSide);
    settings.gather.refinedDirections = 512;
    settings.gather.rays = 64;
    settings.skyRadiance = glm::vec3(1.0F);
    FrameInspector frame(context, scene, noLight(), settings, lookAt({0, 0.2, 2}, {0, 0, 0}, 14));
    const auto nearContact = [&](double from, double to) {
        return deviationOf(frame, [&](const glm::dvec3& p) {
            const double x = glm::length(glm::dvec2(p.x, p.z));
            if (p.y > 1e-4 || x < from || x > to) return -1.0;
            return 1.0 - std::pow(radius / std::hypot(x, radius), 3.0);
        });
    };
    EXPECT_LE(nearContact(0.04, 0.16).rms, 0.25);
    EXPECT_LE(nearContact(0.16, 0.3).rms, 0.045);
}

constexpr double niche = 8.0, behind = 2.03;  // the side of a wall, and its distance from a row of columns

// Adds a black column of 16 smooth sides, over the height of the niche.
void addColumn(Scene& scene, double radius, double x) {
    constexpr std::uint32_t sides = 16;
    Mesh mesh;
    mesh.material = 1;
    mesh.centre = {x, 0, 0};
    for (std::uint32_t i = 0; i <= sides; ++i)
        for (const double y : {-0.5 * niche, 0.5 * niche}) {
            const double angle = 2.0 * pi * i / sides;
            const glm::dvec3 normal(std::sin(angle), 0.0, std::cos(angle));
            mesh.vertices.push_back({glm::vec3(radius * normal + glm::dvec3(0, y, 0)), glm::vec3(normal),
                                     glm::vec2(0.0F), glm::vec2(0.0F)});
        }
    for (std::uint32_t i = 0; i < 2 * sides; i += 2)
        for (const std::uint32_t corner : {i, i + 2, i + 3, i, i + 3, i + 1})
            mesh.indices.push_back(corner);
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
    scene.meshes.push_back(std::move(mesh));
}

// The share of the sky that the wall sees between the columns, as the mean over places and directions.
double skyBetween(const std::vector<double>& columns, double radius) {
    int seen = 0, all = 0;
    for (int i = 0; i < 40 * 40; ++i)
        for (int place = 0; place < 25; ++place) {
            const double r2 = (i % 40 + 0.5) / 40.0,
                         angle = 2.0 * pi * (i / 40 + (place + 0.5) / 25.0) / 40.0;
            const glm::dvec3 to(std::sqrt(r2) * std::cos(angle), std::sqrt(r2) * std::sin(angle),
                                std::sqrt(1.0 - r2));
            const glm::dvec2 from(0.36 * (place % 5 - 2), 0.36 * (place / 5 - 2));
            ++all;
            seen += std::none_of(columns.begin(), columns.end(), [&](double x) {
                const double a = to.x * to.x + to.z * to.z, b = (from.x - x) * to.x - behind * to.z;
                const double c = (from.x - x) * (from.x - x) + behind * behind - radius * radius;
                const double root = b * b - a * c;
                if (root < 0.0) return false;
                const double y = from.y + to.y * (-b - std::sqrt(root)) / a;
                return std::abs(y) < 0.5 * niche;
            });
        }
    return static_cast<double>(seen) / all;
}

// The columns are of 0.9 and 3.7 voxels.
TEST(Gather, RoundColumnsHideAsMuchOfTheSkyAsTheyAreWide) {
    const Context context = openContext(Backend::egl);
    for (const auto& [width, bound] : {std::pair{0.125, 0.08}, {0.5, 0.03}}) {
        Scene scene = emptyScene();
        scene.materials.push_back(scene.materials[0]);
        scene.materials[1].baseColor = glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);
        addQuad(scene, {-0.5 * niche, -0.5 * niche, -behind}, {niche, 0, 0}, {0, niche, 0});
        std::vector<double> columns;
        const int count = static_cast<int>(niche / (2.5 * width));
        for (int i = 0; i < count; ++i) {
            columns.push_back(2.5 * width * (i + 0.5) - 0.5 * niche);
            addColumn(scene, 0.5 * width, columns.back());
        }
        Settings settings = mobileAt(48);
        settings.skyRadiance = glm::vec3(1.0F);
        FrameInspector frame(context, finished(std::move(scene)), noLight(), settings,
                             lookAt({0, 0, -1}, {0, 0, -behind}, 85));
        EXPECT_NEAR(frame.spreadOf(Output::indirectLight).mean / skyBetween(columns, 0.5 * width), 1.0, bound)
            << width;
    }
}

// A closed room of rectangles under a bright sky. The face of a crease would begin its rays outside if they
// began at the middle of its voxel, beyond the other wall.
TEST(Gather, NoSkyShinesIntoTheCreasesOfAClosedRoom) {
    const Context context = openContext(Backend::egl);
    Settings settings = mobileAt(pictureSide);
    settings.skyRadiance = glm::vec3(1.0F);
    FrameInspector frame(context, closedBox(0.0), noLight(), settings, lookAt({0, 0, 0}, {-1, -1, -1}, 80));
    EXPECT_LE(frame.spreadOf(Output::indirectLight).max, 0.0001);
}

// A box whose inside is the front.
void addRoom(Scene& scene, const glm::dvec3& sides, const glm::dvec3& centre) {
    addBox(scene, sides, centre, 0);
    Mesh& room = scene.meshes.back();
    for (Vertex& vertex : room.vertices)
        vertex.normal = -vertex.normal;
    for (std::size_t i = 0; i < room.indices.size(); i += 3)
        std::swap(room.indices[i], room.indices[i + 1]);
}

// A bulb in a closed box of 4.5 voxels, whose walls are a seventh of a voxel thick. What the room receives,
// of what it receives from the bulb without the box. A box that is turned leaks a little, because the outside
// of one wall and the inside of the next share faces along its edges.
TEST(Gather, NoLightLeavesAClosedBox) {
    const Context context = openContext(Backend::egl);
    const auto lightOfRoom = [&](double thickness, const glm::dmat4& turn) {
        Scene scene = closedBox(0.0);
        addBox(scene, glm::dvec3(0.05), {}, addEmitter(scene));
        if (thickness > 0.0) {
            addBox(scene, glm::dvec3(0.15), {}, 0);
            scene.instances.back().worldFromObject = turn;
            addRoom(scene, glm::dvec3(0.15 - 2.0 * thickness), {});
            scene.instances.back().worldFromObject = turn;
        }
        FrameInspector frame(context, finished(std::move(scene)), noLight(), mobileAt(32),
                             lookAt({0.4, 0.4, 0.4}, {1, 1, 1}, 60));
        return frame.spreadOf(Output::indirectLight).mean;
    };
    const double bare = lightOfRoom(0.0, {});
    EXPECT_LE(lightOfRoom(0.005, glm::dmat4(1.0)), 0.002 * bare);
    EXPECT_LE(lightOfRoom(0.005, glm::rotate(glm::dmat4(1.0), glm::radians(30.0), {1, 0, 0})), 0.008 * bare);
}

// A wall thinner than a voxel cuts a room in two, and a lamp lights one half. Along the wall the same voxels
// hold the floor of both halves, whose light must not reach the dark half's floor, back wall or ceiling,
// wherever the wall stands in its voxels. If the room is turned, a little light passes where the wall meets
// others.
TEST(Gather, NoLightPassesAThinWall) {
    const Context context = openContext(Backend::egl);
    const double voxel = 2.0 / 60.0;
    const auto lightOfHalf = [&](double thickness, double inVoxel, double angleDeg, double side) {
        const double wallX = (4.0 + inVoxel) * voxel;
        Scene scene = closedBox(0.0);
        addBox(scene, {thickness * voxel, 2, 2}, {wallX, 0, 0});
        addQuad(scene, {0.99, -0.5, -0.5}, {0, 0, 1}, {0, 1, 0}, addEmitter(scene));
        const glm::dmat4 turn = turnScene(scene, angleDeg);
        const auto turned = [&](const glm::dvec3& p) { return glm::dvec3(turn * glm::dvec4(p, 1.0)); };
        FrameInspector frame(
            context, finished(std::move(scene)), noLight(), mobileAt(64),
            lookAt(turned({wallX + 0.7 * side, 0.1, 0.9}), turned({wallX, -0.1, -0.9}), 100));
        Spread light;
        for (const auto& [surface, irradiance] : frame.seen(Output::irradiance)) {
            const double x = (glm::inverse(turn) * glm::dvec4(surface.positionWorld, 1.0)).x;
            if (std::abs(x - wallX) > (0.5 * thickness + 0.1) * voxel) light.add(irradiance.x);
        }
        EXPECT_GT(light.count, 1000);
        return light.mean;
    };
    const double lit = lightOfHalf(0.3, 0.5, 0.0, 1.0);
    ASSERT_GT(lit, 0.5);
    EXPECT_LE(lightOfHalf(0.3, 0.6, 0.0, -1.0), 0.0001 * lit);
    EXPECT_LE(lightOfHalf(0.7, 0.5, -20.0, -1.0), 0.0028 * lit);
    EXPECT_LE(lightOfHalf(0.3, 0.5, 45.0, -1.0), 0.0088 * lit);
}

// A house of thick walls with two rooms and a wall of 0.74 voxel between them. A lamp lights one room. The
// corners of the other show what passes where the wall meets the ceiling, the floor and other walls. Filtered
// bricks take up to a millionth of those beside them in their texture, by rounding.
TEST(Gather, NoLightPassesBetweenTheRoomsOfAHouse) {
    const Context context = openContext(Backend::egl);
    const glm::dvec3 house(2, 0.75, 2), litRoom(1.875, 0.625, 1.0625), darkRoom(1.875, 0.625, 0.7875);
    const glm::dvec3 litCentre(0, 0, -0.40625), darkCentre(0, 0, 0.54375);
    const auto lightOf = [&](const glm::dvec3& axis, double angleDeg, const glm::dvec3& eye,
                             const glm::dvec3& target) {
        Scene scene = emptyScene();
        addBox(scene, house, {}, 0);
        addRoom(scene, litRoom, litCentre);
        addRoom(scene, darkRoom, darkCentre);
        addQuad(scene, {-0.1, 0.25, -0.5}, {0.2, 0, 0}, {0, 0, 0.2}, addEmitter(scene));
        const glm::dmat4 turn = turnScene(scene, angleDeg, axis);
        const auto turned = [&](const glm::dvec3& p) { return glm::dvec3(turn * glm::dvec4(p, 1.0)); };
        FrameInspector frame(context, finished(std::move(scene)), noLight(), mobileAt(64),
                             lookAt(turned(eye), turned(target), 75));
        return frame.spreadOf(Output::irradiance).mean;
    };
    const glm::dvec3 y(0, 1, 0), x(1, 0, 0);
    const double lit = lightOf(y, 0.0, litCentre, {0.5, -0.2, 0.1});
    ASSERT_GT(lit, 0.1);
    struct Turned {
        glm::dvec3 axis;
        double angleDeg, bound;
    };
    for (const auto& [axis, angleDeg, bound] :
         {Turned{y, 0, 2e-6}, Turned{y, 40, 0.003}, Turned{x, 15, 1e-5}})
        for (const double corner : {-1.0, 1.0})
            EXPECT_LE(lightOf(axis, angleDeg, {0.65 * corner, 0.1 * corner, 0.4},
                              {0.9 * corner, 0.3 * corner, 0.15}),
                      bound * lit)
                << axis.x << angleDeg << corner;
}

// A bar on the dark side of a thin wall, so thin that the voxels miss it. In the blocks around, the only
// faces that look to the bar's +x side are those of the wall's lit side. The floor below the bar is nearer.
TEST(LookUp, ABarThatTheVoxelsMissTakesTheLightOfTheFloorBelow) {
    const Context context = openContext(Backend::egl);
    const double voxel = 2.0 / 60.0, wallX = 4.0 * voxel, barX = wallX - 6.0 * voxel;
    Scene scene = closedBox(0.0);
    addBox(scene, {0.3 * voxel, 2, 2}, {wallX, 0, 0});
    addBox(scene, {0.06 * voxel, 3 * voxel, 0.06 * voxel}, {barX, 1.5 * voxel - 1.0, 0});
    addQuad(scene, {0.99, -0.5, -0.5}, {0, 0, 1}, {0, 1, 0}, addEmitter(scene));
    Camera camera = lookAt({barX + 0.06, -0.94, 0.02}, {barX, 1.5 * voxel - 1.0, 0}, 60);
    camera.nearest = 0.01;
    FrameInspector frame(context, finished(std::move(scene)), noLight(), mobileAt(pictureSide), camera);
    Spread bar, floor;
    for (const auto& [surface, light] : frame.seen(Output::irradiance)) {
        if (surface.normal.x > 0.5 && std::abs(surface.positionWorld.x - barX) < 0.1 * voxel)
            bar.add(light.x);
        if (surface.normal.y > 0.5) floor.add(light.x);
    }
    ASSERT_GT(bar.count, 20);
    ASSERT_GT(floor.count, 100);
    EXPECT_LE(bar.max, 1.5 * floor.max);
}

// A lathe's mesh shares vertices between its side and its bottom. Along such a normal a ray would start in
// the dark below the floor.
TEST(Gather, AWallsFootIsLitWhereItsNormalsLeanIntoTheFloor) {
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, addEmitter(scene));
    addQuad(scene, {-1, 0, 0}, {2, 0, 0}, {0, 0.5, 0});
    for (const std::size_t bottom : {0U, 1U})
        scene.meshes.back().vertices[bottom].normal = glm::normalize(glm::vec3(0, -1, 1));
    scene = finished(std::move(scene));
    const Settings settings = mobileAt(pictureSide);
    FrameInspector frame(context, scene, noLight(), settings, lookAt({0, 0.2, 1.5}, {0, 0.1, 0}, 20));
    Spread foot;
    for (const auto& [surface, light] : frame.seen(Output::indirectLight))
        if (surface.positionWorld.y > 1e-3 && surface.positionWorld.y < 0.05) foot.add(light.x);
    ASSERT_GT(foot.count, 500);
    EXPECT_GE(foot.min, 0.6);
}

// The inside of a closed box has the radiance 1, so the right answer is 1 everywhere.
TEST(Gather, WhiteFurnaceIsOne) {
    const Context context = openContext(Backend::egl);
    for (const double turnDeg : {0.0, 30.0}) {
        SCOPED_TRACE(turnDeg);
        Scene scene = closedBox(turnDeg);
        scene.materials[0].emissive = glm::vec3(1.0F);
        FrameInspector frame(context, scene, noLight(), mobileAt(pictureSide),
                             lookAt({0, 0, 0}, {0.2, -0.4, -1}, 120));
        const Spread spread = frame.spreadOf(Output::indirectLight);
        EXPECT_NEAR(spread.mean, 1.0, turnDeg == 0.0 ? 0.001 : 0.006);
        EXPECT_LE(spread.max, 1.001);
        EXPECT_GE(spread.min, turnDeg == 0.0 ? 0.999 : 0.3);
        // Walls of a turned box that meet share faces, whose middle may lie beyond a wall.
        double weight = 0.0, light = 0.0;
        for (const auto& [entry, face] : frame.irradiance(false)) {
            weight += face.coverage;
            light += face.coverage * face.light.g;
            EXPECT_LE(face.light.g, 1.001);
        }
        EXPECT_NEAR(light / weight, 1.0, turnDeg == 0.0 ? 0.001 : 0.01);
    }
}

// A plane does not light itself, nor does the lit side of a sheet light its dark side, whose faces lie in the
// same voxels.
TEST(Gather, NeitherSideOfALitPlaneGetsAnything) {
    const Context context = openContext(Backend::egl);
    for (const double turnDeg : {0.0, 30.0})
        for (const bool darkSide : {false, true}) {
            SCOPED_TRACE(testing::Message() << (darkSide ? "dark" : "lit") << " side turned by " << turnDeg);
            Scene scene = lonePlane(turnDeg);
            scene.materials.front().doubleSided = darkSide;
            const glm::dvec3 up(scene.instances[0].worldFromObject * glm::dvec4(0, 1, 0, 0));
            FrameInspector frame(context, scene, lightFrom(darkSide ? -up : up), mobileAt(pictureSide),
                                 lookAt(3.0 * up + glm::dvec3(0.3, 0, 0), {0, 0, 0}, 40));
            const Spread light = frame.spreadOf(Output::indirectLight),
                         ambientVisibility = frame.spreadOf(Output::ambientVisibility);
            ASSERT_GT(light.count, 1000);
            EXPECT_GE(light.min, 0.0);
            if (darkSide) {
                EXPECT_LE(light.mean, 0.03);  // turned by 30 degrees: .019; with its own back .2 to .6
                EXPECT_GE(ambientVisibility.mean, 0.98);
            } else {
                EXPECT_LE(light.mean, 1e-4);
                EXPECT_LE(light.max, 1e-3);
                EXPECT_GE(ambientVisibility.min, 0.999);
            }
        }
}

// The emitter shares voxels with the ceiling, and must send as much light as without one.
TEST(Gather, AnEmitterRightUnderACeilingSendsAllItsLight) {
    const Context context = openContext(Backend::egl);
    double light[2] = {};
    for (const bool ceiling : {false, true}) {
        Scene scene = emptyScene();
        scene.materials[0].baseColor = glm::vec4(0, 0, 0, 1);
        addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
        addQuad(scene, {-0.5, 0.999, -0.5}, {1, 0, 0}, {0, 0, 1}, addEmitter(scene));
        if (ceiling) addQuad(scene, {-1, 1, -1}, {2, 0, 0}, {0, 0, 2});
        scene = finished(std::move(scene));
        FrameInspector frame(context, scene, noLight(), mobileAt(16), lookAt({0, 0.5, 0}, {0, 0, 0.01}, 40));
        for (const auto& [entry, face] : frame.irradiance(true))
            if (shared::unpackFace(entry) == 2) light[ceiling ? 1 : 0] += face.coverage * face.light.g;
    }
    EXPECT_NEAR(light[1] / light[0], 1.0, 0.0001);
}

}  // namespace
}  // namespace vct::test
