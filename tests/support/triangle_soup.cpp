#include "support/triangle_soup.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "support/scenes.h"

namespace vct::test {

namespace {

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    // The same on every standard library, as its distributions are not.
    float uniform(float low, float high) {
        return low + (high - low) * static_cast<float>(engine_() >> 8) / static_cast<float>(1U << 24);
    }
    glm::vec3 inCube(float half) {
        return {uniform(-half, half), uniform(-half, half), uniform(-half, half)};
    }

  private:
    std::mt19937 engine_;
};

void addTriangle(Mesh& mesh, Random& random) {
    const float size = std::pow(10.0F, random.uniform(-3.0F, -0.3F));
    const glm::vec3 a = random.inCube(1.0F);
    glm::vec3 u = random.inCube(size), v = random.inCube(size);
    const float kind = random.uniform(0.0F, 1.0F);
    if (kind < 0.3F)  // a plane at 45 degrees, up to rounding
        u = {u.x, u.x, 0.0F}, v = {0.0F, 0.0F, v.z};
    else if (kind < 0.35F)
        v = 2.0F * u;
    else if (kind < 0.45F)  // a needle
        v = u + random.inCube(0.01F * size);
    const glm::vec3 normal = glm::cross(u, v);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::vec3& p : {a, a + u, a + v})
        mesh.vertices.push_back({p,
                                 glm::length(normal) > 0.0F ? glm::normalize(normal) : glm::vec3(0, 1, 0),
                                 {random.uniform(0.0F, 3.0F), random.uniform(0.0F, 3.0F)},
                                 {}});
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
}

std::vector<Material> materials() {
    std::vector<Material> result(4);
    result[1].doubleSided = true;
    result[1].baseColor = {0.9F, 0.5F, 0.2F, 1.0F};
    result[2].emissive = {0.4F, 0.2F, 0.7F};
    result[3].alphaMode = Material::AlphaMode::mask;
    result[3].baseColorTexture = 0;
    return result;
}

Texture chequers() {
    Texture texture;
    texture.name = "chequers";
    texture.width = texture.height = 8;
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < 64; ++i)
        for (int c = 0; c < 4; ++c)
            rgba.push_back((i + i / 8) % 2 == 0 || c == i % 3 ? 255 : 0);
    texture.rgba = rgba;
    return texture;
}

}  // namespace

Scene triangleSoup(unsigned seed) {
    Random random(seed);
    Scene scene = emptyScene();
    scene.materials = materials();
    scene.textures = {chequers()};
    for (int m = 0; m < 4; ++m) {
        Mesh mesh;
        mesh.name = "soup";
        mesh.material = m;
        for (int i = 0; i < 400; ++i)
            addTriangle(mesh, random);
        scene.meshes.push_back(mesh);
        const glm::dmat4 none(1.0);
        const glm::dvec3 away(random.inCube(2.0F));
        const glm::dvec3 axis = glm::normalize(glm::dvec3(random.inCube(1.0F)));
        const glm::dmat4 turned = glm::rotate(none, 6.0 * random.uniform(0.0F, 1.0F), axis);
        for (const glm::dmat4& worldFromObject :
             {none, glm::translate(none, away), turned * glm::scale(none, glm::dvec3(1.3, 0.7, 1.0)),
              glm::translate(none, -away) * glm::scale(turned, glm::dvec3(-1.0, 1.0, 1.0)),
              glm::translate(none, away) * glm::scale(turned, glm::dvec3(1.0, 0.0, 1.0))})
            scene.instances.push_back({m, worldFromObject});
    }
    return finished(std::move(scene));
}

}  // namespace vct::test
