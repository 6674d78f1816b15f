#include "support/scenes.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "scene/gltf.h"

namespace vct::test {

Scene emptyScene() {
    Scene scene;
    scene.path = "test";
    scene.materials.emplace_back().metallic = 0.0F;
    return scene;
}

void addQuad(Scene& scene, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, int material) {
    Mesh mesh;
    mesh.material = material;
    const glm::vec3 normal(glm::normalize(glm::cross(u, v)));
    for (const glm::dvec3& p : {corner, corner + u, corner + u + v, corner + v})
        mesh.vertices.push_back({glm::vec3(p), normal, glm::vec2(0.0F), glm::vec2(0.0F)});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
    scene.meshes.push_back(std::move(mesh));
}

void addBox(Scene& scene, const glm::dvec3& sides, const glm::dvec3& centre, int material) {
    Mesh mesh;
    mesh.material = material;
    mesh.centre = centre;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 normal(0.0), u(0.0), v(0.0);
            normal[axis] = side;
            u[(axis + 1) % 3] = sides[(axis + 1) % 3];
            v[(axis + 2) % 3] = side * sides[(axis + 2) % 3];
            const glm::dvec3 corner = 0.5 * (normal * sides - u - v);
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const glm::dvec3& p : {corner, corner + u, corner + u + v, corner + v})
                mesh.vertices.push_back({glm::vec3(p), glm::vec3(normal), glm::vec2(0.0F), glm::vec2(0.0F)});
            for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U})
                mesh.indices.push_back(first + i);
        }
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
    scene.meshes.push_back(std::move(mesh));
}

void addBall(Scene& scene, double radius, const glm::dvec3& centre, int material) {
    constexpr std::uint32_t segments = 64, rings = 32;
    Mesh mesh;
    mesh.material = material;
    mesh.centre = centre;
    for (std::uint32_t ring = 0; ring <= rings; ++ring)
        for (std::uint32_t i = 0; i <= segments; ++i) {
            const double polar = pi * ring / rings, azimuth = 2.0 * pi * i / segments;
            const glm::dvec3 normal(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                    std::sin(polar) * std::cos(azimuth));
            mesh.vertices.push_back(
                {glm::vec3(radius * normal), glm::vec3(normal), glm::vec2(0.0F), glm::vec2(0.0F)});
        }
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t i = 0; i < segments; ++i) {
            const std::uint32_t a = ring * (segments + 1) + i, b = a + segments + 1;
            for (const std::uint32_t corner : {a, b, b + 1, a, b + 1, a + 1})
                mesh.indices.push_back(corner);
        }
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
    scene.meshes.push_back(std::move(mesh));
}

glm::dmat4 turnScene(Scene& scene, double angleDeg, const glm::dvec3& axis) {
    const glm::dmat4 rotation = glm::rotate(glm::dmat4(1.0), glm::radians(angleDeg), glm::normalize(axis));
    for (Instance& instance : scene.instances)
        instance.worldFromObject = rotation * instance.worldFromObject;
    return rotation;
}

Scene closedBox(double angleDeg) {
    Scene scene = emptyScene();
    const glm::dvec3 x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
    addQuad(scene, {-1, -1, -1}, z, x);  // floor, facing +y
    addQuad(scene, {-1, 1, -1}, x, z);   // ceiling
    addQuad(scene, {-1, -1, -1}, y, z);  // left, facing +x
    addQuad(scene, {1, -1, -1}, z, y);   // right
    addQuad(scene, {-1, -1, -1}, x, y);  // back, facing +z
    addQuad(scene, {-1, -1, 1}, y, x);   // front
    turnScene(scene, angleDeg);
    return finished(std::move(scene));
}

Scene lonePlane(double angleDeg) {
    Scene scene = emptyScene();
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    turnScene(scene, angleDeg);
    return finished(std::move(scene));
}

Scene hall() {
    Scene scene = emptyScene();
    scene.materials.push_back(scene.materials[0]);
    scene.materials[0].baseColor = glm::vec4(0.7F, 0.7F, 0.7F, 1.0F);
    scene.materials[1].baseColor = glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);
    scene.materials[1].emissive = glm::vec3(1.0F);
    addQuad(scene, {0, 0, 0}, {0, 0, 8}, {24, 0, 0});
    addQuad(scene, {0, 6, 0}, {24, 0, 0}, {0, 0, 8});
    addQuad(scene, {0, 0, 0}, {24, 0, 0}, {0, 6, 0});
    addQuad(scene, {0, 0, 8}, {0, 6, 0}, {24, 0, 0});
    addQuad(scene, {0, 0, 0}, {0, 6, 0}, {0, 0, 8});
    addQuad(scene, {24, 0, 0}, {0, 0, 8}, {0, 6, 0});
    addQuad(scene, {8, 5.8, 2}, {8, 0, 0}, {0, 0, 4}, 1);
    return finished(std::move(scene));
}

void shuffleTriangles(Scene& scene, unsigned seed) {
    std::mt19937 random(seed);
    std::shuffle(scene.instances.begin(), scene.instances.end(), random);
    for (Mesh& mesh : scene.meshes) {
        std::vector<glm::uvec3> triangles;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            triangles.emplace_back(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
        std::shuffle(triangles.begin(), triangles.end(), random);
        mesh.indices.clear();
        for (const glm::uvec3& corners : triangles)
            mesh.indices.insert(mesh.indices.end(), {corners.x, corners.y, corners.z});
    }
}

Scene finished(Scene scene) {
    computeBounds(scene);
    return scene;
}

DirectionalLight lightFrom(const glm::dvec3& directionToLight) {
    DirectionalLight light;
    light.directionToLight = glm::normalize(directionToLight);
    return light;
}

DirectionalLight noLight() {
    DirectionalLight light = lightFrom({0, 1, 0});
    light.intensity = 0.0F;
    return light;
}

}  // namespace vct::test
