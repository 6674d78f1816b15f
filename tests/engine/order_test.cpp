// Coincident surfaces, whose order could decide the picture, and perpendicular light, where rounding could.
#include <gtest/gtest.h>

#include "scene/camera.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

Image picture(const Context& context, const Scene& scene, const DirectionalLight& light, Output mode,
              const Camera& camera) {
    Renderer renderer = makeRenderer(context, scene, light, smallSettings());
    renderer.render({{mode}, camera});
    return renderer.radiance();
}

TEST(OrderOfInstances, DoesNotChangeAPictureOfCoincidentSurfaces) {
    const Context context = openContext(Backend::egl);
    Scene scene = emptyScene();
    for (int i = 0; i < 4; ++i) {
        Material material = scene.materials[0];
        material.baseColor = glm::vec4(0.2F * static_cast<float>(i), 0.3F, 0.6F, 1.0F);
        scene.materials.push_back(material);
        addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, i + 1);
    }
    // The same mesh is in the same place twice.
    scene.instances.push_back(scene.instances[0]);
    addQuad(scene, {-1, 0, 0}, {2, 0, 0}, {0, 1, 0}, 1);
    scene = finished(std::move(scene));
    const Camera camera = lookAt({0.4, 1.6, 2.4}, {0, 0.2, 0}, 50);
    const Image first = picture(context, scene, lightFrom({1, 2, 3}), Output::gi, camera);
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Scene shuffled = scene;
        shuffleTriangles(shuffled, seed);
        EXPECT_EQ(picture(context, shuffled, lightFrom({1, 2, 3}), Output::gi, camera).pixels, first.pixels)
            << "seed " << seed;
    }
}

// Eq. 4.2 gives no bias where the light is perpendicular: rounding must not shade the surface by itself.
TEST(ShadowMapBias, PerpendicularLightLeavesNoAcne) {
    const Context context = openContext(Backend::egl);
    for (const glm::dvec3& up : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0),
                                 glm::dvec3(0.48, 0.6, 0.64), glm::dvec3(-0.8, 0.36, 0.48)}) {
        Scene scene = emptyScene();
        const glm::dvec3 helper = std::abs(up.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
        const glm::dvec3 u = glm::normalize(glm::cross(helper, up));
        const glm::dvec3 v = glm::cross(up, u);
        addQuad(scene, -30.0 * (u + v), 60.0 * u, 60.0 * v);
        // This quad gives the depth range an extent. Its shadow is outside the picture.
        addQuad(scene, 20.0 * (u + v) + 13.7 * up, 4.0 * u, 4.0 * v);
        scene = finished(std::move(scene));
        const Camera camera = lookAt(40.0 * up - 5.0 * u, -5.0 * u, 40);
        const Image image = picture(context, scene, lightFrom(up), Output::shadowMap, camera);
        float least = 1e9F;
        float largest = 0.0F;
        for (const glm::vec3& pixel : image.pixels) {
            least = std::min(least, pixel.x);
            largest = std::max(largest, pixel.x);
        }
        EXPECT_GT(least, 0.7F * largest) << "towards " << up.x << " " << up.y << " " << up.z;
        EXPECT_GT(least, 0.0F);
    }
}

}  // namespace
}  // namespace vct::test
