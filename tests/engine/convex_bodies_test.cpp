// The sun on convex bodies with smooth normals. A convex body casts no shadow onto itself: the sun reaches
// exactly the triangles that are turned to it, however much the normals differ from the triangles'.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

// Adds a body of revolution around +Y, with smooth normals. `profile`: radius and height, from bottom to top.
void addTurned(Scene& scene, const std::vector<glm::dvec2>& profile, int segments) {
    Mesh mesh;
    const auto rings = static_cast<int>(profile.size());
    for (int ring = 0; ring < rings; ++ring) {
        const glm::dvec2 along = profile[static_cast<std::size_t>(std::min(ring + 1, rings - 1))] -
                                 profile[static_cast<std::size_t>(std::max(ring - 1, 0))];
        const glm::dvec2 outwards = glm::normalize(glm::dvec2(along.y, -along.x));
        for (int i = 0; i <= segments; ++i) {
            const double angle = 2.0 * pi * i / segments;
            const auto around = [&](const glm::dvec2& p) {
                return glm::vec3(p.x * std::cos(angle), p.y, -p.x * std::sin(angle));
            };
            mesh.vertices.push_back({around(profile[static_cast<std::size_t>(ring)]), around(outwards),
                                     glm::vec2(0.0F), glm::vec2(0.0F)});
        }
    }
    for (int ring = 0; ring + 1 < rings; ++ring)
        for (int i = 0; i < segments; ++i) {
            const auto a = static_cast<std::uint32_t>(ring * (segments + 1) + i);
            const auto above = a + static_cast<std::uint32_t>(segments) + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, above + 1, a, above + 1, above});
        }
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
    scene.meshes.push_back(std::move(mesh));
}

std::vector<glm::dvec2> halfCircles(int rings, double straight) {
    std::vector<glm::dvec2> profile;
    for (int ring = 0; ring <= rings; ++ring) {
        const double angle = pi * ring / rings;
        const double height = -std::cos(angle);
        if (straight > 0.0 && 2 * ring == rings) profile.emplace_back(1.0, -straight);
        profile.emplace_back(std::sin(angle), height + (2 * ring < rings ? -straight : straight));
    }
    return profile;
}

struct Body {
    const char* name;
    int segments, rings;
    double straight;  // half the length of the cylinder between the halves of the sphere
};
void PrintTo(const Body& body, std::ostream* out) {
    *out << body.name;
}

struct Truth {
    glm::dvec3 face, shading;
};

// The normals of the triangle that each pixel shows, in world space.
std::vector<Truth> truthOf(const Mesh& mesh, const std::vector<SurfacePixel>& pixels) {
    std::vector<Truth> truths(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].surface) continue;
        double least = HUGE_VAL;
        for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
            const Vertex &a = mesh.vertices[mesh.indices[t]], &b = mesh.vertices[mesh.indices[t + 1]],
                         &c = mesh.vertices[mesh.indices[t + 2]];
            const glm::dvec3 origin(a.position), u(glm::dvec3(b.position) - origin),
                v(glm::dvec3(c.position) - origin);
            const glm::dvec3 area = glm::cross(u, v);
            const double area2 = glm::dot(area, area);
            if (area2 < 1e-12) continue;
            const glm::dvec3 p = pixels[i].positionWorld - origin;
            const double second = glm::dot(glm::cross(p, v), area) / area2,
                         third = glm::dot(glm::cross(u, p), area) / area2;
            const double outside = std::max({-second, -third, second + third - 1.0, 0.0});
            const double away = std::abs(glm::dot(p, area)) / std::sqrt(area2) + outside;
            if (away >= least) continue;
            least = away;
            truths[i] = {glm::normalize(area),
                         glm::normalize(glm::dvec3(a.normal) * (1.0 - second - third) +
                                        glm::dvec3(b.normal) * second + glm::dvec3(c.normal) * third)};
        }
    }
    return truths;
}

class ConvexBodies : public testing::TestWithParam<Body> {};

TEST_P(ConvexBodies, DoNotShadowThemselves) {
    const Body& body = GetParam();
    Scene scene = emptyScene();
    addTurned(scene, halfCircles(body.rings, body.straight), body.segments);
    const Mesh mesh = scene.meshes.front();
    addQuad(scene, {-6, -2.5, 6}, {12, 0, 0}, {0, 0, -12});  // a floor, for a volume larger than the body
    Settings settings = unrefinedPreset("mobile");
    settings.size = glm::ivec2(160);
    const Context context = openContext(Backend::egl);
    FrameInspector frame(context, finished(std::move(scene)), lightFrom({0, 1, 0}), settings,
                         lookAt({2.0, 1.5, 5.5}, {0, 0, 0}, 42.0 + 20.0 * body.straight));
    const std::vector<SurfacePixel>& pixels = frame.pixels();
    const std::vector<Truth> truths = truthOf(mesh, pixels);

    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    int lit = 0, away = 0;
    std::array<int, 2> dark{}, leaks{};
    for (int sun = 0; sun < 10; ++sun) {
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(normal(random), std::abs(normal(random)) + 0.1, normal(random)));
        frame.setLight(direction);
        const std::vector<float> shares[2] = {frame.mode2Shadow(), frame.softShadow()};
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (!pixels[i].surface || pixels[i].positionWorld.y < -2.4) continue;
            const double face = glm::dot(truths[i].face, direction);
            const bool faces = face > 0.02 && glm::dot(truths[i].shading, direction) > 0.02;
            lit += faces ? 1 : 0;
            away += face < -0.02 ? 1 : 0;
            for (std::size_t k = 0; k < 2; ++k) {
                dark[k] += faces && shares[k][i] < 0.7F ? 1 : 0;
                leaks[k] += face < -0.02 && shares[k][i] > 0.3F ? 1 : 0;
            }
        }
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const char* const name = k == 0 ? "hard" : "soft";
        EXPECT_LE(dark[k], 0.001 * lit) << name << ": dark pixels in the sun, of " << lit;
        EXPECT_LE(leaks[k], 0.001 * away) << name << ": lit pixels that face away, of " << away;
    }
}

TEST(ConvexMirror, DoesNotReflectItself) {
    Scene scene = emptyScene();
    addTurned(scene, halfCircles(16, 0.0), 32);
    scene.materials[0].metallic = 1.0F;
    scene.materials[0].roughness = 0.0F;
    Settings settings = unrefinedPreset("mobile");
    settings.size = glm::ivec2(96);
    const Context context = openContext(Backend::egl);
    FrameInspector frame(context, finished(std::move(scene)), lightFrom({0, 0, 1}), settings,
                         lookAt({0, 0.3, 4.0}, {0, 0, 0}, 34.0));
    for (const glm::dvec3& sun : {glm::dvec3(1, 0.4, 0.3), glm::dvec3(-0.8, 0.6, -0.5)}) {
        frame.setLight(sun);
        const Spread seen = frame.spreadOf(Output::specularLight);
        EXPECT_GT(seen.count, 3000);
        EXPECT_LT(seen.max, 0.02) << sun.x << " " << sun.y << " " << sun.z;
    }
}

INSTANTIATE_TEST_SUITE_P(Bodies, ConvexBodies,
                         testing::Values(Body{"sphere of 4", 4, 4, 0.0}, Body{"sphere of 8", 8, 6, 0.0},
                                         Body{"sphere of 16", 16, 8, 0.0}, Body{"sphere of 64", 64, 32, 0.0},
                                         Body{"capsule", 12, 6, 1.0}));

}  // namespace
}  // namespace vct::test
