// The sun on bodies that a skin or morph targets deform. Rays through their triangles tell what it reaches.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/moving_scenes.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

struct Triangle {
    glm::dvec3 a, u, v;  // u and v: from a to the other corners
    std::array<glm::dvec3, 3> normals;
};

// The triangles of a scene whose vertices are in world space.
std::vector<Triangle> trianglesOf(const Scene& scene) {
    std::vector<Triangle> triangles;
    for (const Mesh& mesh : scene.meshes)
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            std::array<glm::dvec3, 3> corners, normals;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vertex& vertex = mesh.vertices[mesh.indices[i + k]];
                corners[k] = mesh.centre + glm::dvec3(vertex.position);
                normals[k] = glm::dvec3(vertex.normal);
            }
            triangles.push_back({corners[0], corners[1] - corners[0], corners[2] - corners[0], normals});
        }
    return triangles;
}

struct Hit {
    std::size_t triangle = SIZE_MAX;
    double second = 0.0, third = 0.0;  // weights of the corners
};

Hit firstHit(const std::vector<Triangle>& triangles, const glm::dvec3& from, const glm::dvec3& direction,
             std::size_t except = SIZE_MAX) {
    Hit hit;
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        const glm::dvec3 p = glm::cross(direction, t.v), s = from - t.a, q = glm::cross(s, t.u);
        const double det = glm::dot(t.u, p);
        if (i == except || std::abs(det) < 1e-14) continue;
        const double second = glm::dot(s, p) / det, third = glm::dot(direction, q) / det;
        const double distance = glm::dot(t.v, q) / det;
        if (second < 0.0 || third < 0.0 || second + third > 1.0 || distance < 1e-9 || distance > nearest)
            continue;
        nearest = distance;
        hit = {i, second, third};
    }
    return hit;
}

enum class Sun { unsure, reaches, doesNotReach };

// The sun at the point that a ray from the eye meets. It is unsure where parts of a disc, somewhat larger
// than the sun's, are hidden, and where the sun grazes the surface or its shading normal.
Sun sunAt(const std::vector<Triangle>& triangles, const glm::dvec3& eye, const glm::dvec3& ray,
          const glm::dvec3& sun) {
    const Hit seen = firstHit(triangles, eye, ray);
    if (seen.triangle == SIZE_MAX) return Sun::unsure;
    const Triangle& t = triangles[seen.triangle];
    const glm::dvec3 face = glm::normalize(glm::cross(t.u, t.v));
    const double side = glm::dot(face, ray) < 0.0 ? 1.0 : -1.0;
    const double cosine = side * glm::dot(face, sun);
    const double shading = side * glm::dot(t.normals[0] * (1.0 - seen.second - seen.third) +
                                               t.normals[1] * seen.second + t.normals[2] * seen.third,
                                           sun);
    if (cosine < -0.02) return Sun::doesNotReach;
    const glm::dvec3 point = t.a + seen.second * t.u + seen.third * t.v;
    const glm::dvec3 x =
        glm::normalize(glm::cross(sun, std::abs(sun.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
    const glm::dvec3 y = glm::cross(sun, x);
    int hidden = 0;
    constexpr int rays = 9;
    for (int k = 0; k < rays; ++k) {
        const double radius = k == 0 ? 0.0 : 0.06, angle = 2.0 * pi * k / (rays - 1);
        const glm::dvec3 direction = sun + radius * (std::cos(angle) * x + std::sin(angle) * y);
        if (firstHit(triangles, point, direction, seen.triangle).triangle != SIZE_MAX) ++hidden;
    }
    if (cosine > 0.02 && hidden == rays) return Sun::doesNotReach;
    return cosine > 0.02 && shading > 0.02 && hidden == 0 ? Sun::reaches : Sun::unsure;
}

// A strip of 3 x 1 m of 20 x 4 quads that two joints fold, by -150 to 150 degrees in 2 s.
Scene foldingStrip() {
    GltfBuilder builder;
    std::vector<float> positions, normals, weights;
    std::vector<std::uint8_t> joints;
    std::vector<std::uint16_t> indices;
    constexpr int length = 20, width = 4;
    for (int i = 0; i <= length; ++i)
        for (int k = 0; k <= width; ++k) {
            const float x = 3.0F * static_cast<float>(i) / length - 1.5F;
            positions.insert(positions.end(), {x, 0.0F, static_cast<float>(k) / width - 0.5F});
            normals.insert(normals.end(), {0, 1, 0});
            const float share = std::clamp(0.5F + x / 1.5F, 0.0F, 1.0F);
            joints.insert(joints.end(), {0, 1, 0, 0});
            weights.insert(weights.end(), {1.0F - share, share, 0, 0});
            if (i == length || k == width) continue;
            const int a = i * (width + 1) + k, next = a + width + 1;
            for (const int index : {a, a + 1, next, next, a + 1, next + 1})
                indices.push_back(static_cast<std::uint16_t>(index));
        }
    const int material =
        builder.add("materials", {{"doubleSided", true}, {"pbrMetallicRoughness", {{"metallicFactor", 0}}}});
    const int left = builder.node({{"name", "left"}}), right = builder.node({{"name", "right"}});
    builder.add("skins", {{"joints", {left, right}}});
    builder.node({{"mesh", builder.mesh({{"attributes",
                                          {{"POSITION", builder.floats(positions)},
                                           {"NORMAL", builder.floats(normals)},
                                           {"JOINTS_0", builder.accessor(joints, uint8, "VEC4")},
                                           {"WEIGHTS_0", builder.floats(weights, "VEC4")}}},
                                         {"indices", builder.accessor(indices, uint16, "SCALAR")},
                                         {"material", material}})},
                  {"skin", 0}});
    const float sine = std::sin(0.6544985F), cosine = std::cos(0.6544985F);  // of half of 75 degrees
    builder.animate(left, "rotation", {0, 1, 2}, {0, 0, sine, cosine, 0, 0, 0, 1, 0, 0, -sine, cosine});
    builder.animate(right, "rotation", {0, 1, 2}, {0, 0, -sine, cosine, 0, 0, 0, 1, 0, 0, sine, cosine});
    return load(builder);
}

// A coarse sphere that becomes an ellipsoid and then has a bulge. Its targets have no normals, so the shading
// normals differ much from the triangles'.
Scene morphingSphere() {
    GltfBuilder builder;
    std::vector<float> positions, longer, bulge;
    std::vector<std::uint16_t> indices;
    constexpr int segments = 8, rings = 5;
    for (int ring = 0; ring <= rings; ++ring)
        for (int i = 0; i <= segments; ++i) {
            const double height = pi * ring / rings, around = 2.0 * pi * i / segments;
            const glm::vec3 p(std::sin(height) * std::cos(around), -std::cos(height),
                              -std::sin(height) * std::sin(around));
            positions.insert(positions.end(), {p.x, p.y, p.z});
            longer.insert(longer.end(), {0.6F * p.x, -0.5F * p.y, 0.0F});
            const float swelling = 0.35F * std::max(p.y, 0.0F);
            bulge.insert(bulge.end(), {swelling * p.x, swelling * p.y, swelling * p.z});
            if (ring == rings || i == segments) continue;
            const int a = ring * (segments + 1) + i, above = a + segments + 1;
            for (const int index : {a, a + 1, above + 1, a, above + 1, above})
                indices.push_back(static_cast<std::uint16_t>(index));
        }
    const int points = builder.floats(positions);
    const int node = builder.node(
        {{"mesh", builder.mesh(
                      {{"attributes", {{"POSITION", points}, {"NORMAL", points}}},
                       {"indices", builder.accessor(indices, uint16, "SCALAR")},
                       {"targets",
                        {{{"POSITION", builder.floats(longer)}}, {{"POSITION", builder.floats(bulge)}}}}})}});
    builder.animate(node, "weights", {0, 1, 2}, {1, 0, 0, 0, 0, 1});
    return load(builder);
}

// Draws the scene in several poses and suns, with hard and soft shadows.
void expectNoSelfShadow(const Scene& scene) {
    Settings settings = presetSettings("mobile");
    settings.size = glm::ivec2(128);
    const Context context = openContext(Backend::egl);
    const Camera camera = lookAt({1.2, 1.9, 4.5}, {0, 0, 0}, 45.0);
    const glm::dvec3 eye(camera.worldFromCamera[3]);
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    int lit = 0, away = 0;
    std::array<int, 2> dark{}, leaks{};
    for (const double seconds : {0.1, 0.8, 1.6, 1.95}) {
        const std::vector<Triangle> triangles = trianglesOf(frozenAt(scene, seconds));
        FrameInspector frame(context, scene, lightFrom({0, 1, 0}), settings, camera);
        frame.renderer().setPose(poseAt(scene.animation, seconds));
        const std::vector<SurfacePixel>& pixels = frame.pixels();
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 sun = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
            frame.setLight(sun);
            const std::vector<float> shares[2] = {frame.mode2Shadow(), frame.softShadow()};
            for (std::size_t p = 0; p < pixels.size(); ++p) {
                if (!pixels[p].surface) continue;
                const Sun there = sunAt(triangles, eye, pixels[p].positionWorld - eye, sun);
                lit += there == Sun::reaches ? 1 : 0;
                away += there == Sun::doesNotReach ? 1 : 0;
                for (std::size_t k = 0; k < 2; ++k) {
                    dark[k] += there == Sun::reaches && shares[k][p] < 0.7F ? 1 : 0;
                    leaks[k] += there == Sun::doesNotReach && shares[k][p] > 0.3F ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(lit, 4000);
    EXPECT_GT(away, 4000);
    for (std::size_t k = 0; k < 2; ++k) {
        const char* const name = k == 0 ? "hard" : "soft";
        EXPECT_LE(dark[k], 0.001 * lit) << name << ": dark pixels in the sun, of " << lit;
        EXPECT_LE(leaks[k], 0.001 * away) << name << ": lit pixels that the sun does not reach, of " << away;
    }
}

TEST(PosedBodies, AFoldedStripShadowsOnlyWhatIsBehindIt) {
    expectNoSelfShadow(foldingStrip());
}

TEST(PosedBodies, AMorphingSphereDoesNotShadowItself) {
    expectNoSelfShadow(morphingSphere());
}

}  // namespace
}  // namespace vct::test
