// A scene that is written in another way has the same light.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/renderers.h"
#include "support/scenes.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

class Invariance : public testing::TestWithParam<const char*> {
  protected:
    Image picture(const Scene& scene, const DirectionalLight& light, const Camera& camera) const {
        Settings settings = smallPreset(GetParam());
        settings.lightFrames = 2;
        settings.gather.directions = settings.gather.rays;
        Renderer renderer = makeRenderer(context_, scene, light, settings, programs_);
        renderer.render({{Output::giConeShadow}, camera, LightSteps::all});
        return renderer.radiance();
    }

    const Context context_ = openContext(Backend::egl);
    const std::shared_ptr<gl::ProgramCache> programs_ = std::make_shared<gl::ProgramCache>();
};
INSTANTIATE_TEST_SUITE_P(Presets, Invariance, everyVoxelKind(), nameOfPreset);

// The mean difference is at most `share` of the mean.
void expectAlike(const Image& picture, const Image& expected, double share, const std::string& what,
                 float factor = 1.0F) {
    ASSERT_EQ(picture.pixels.size(), expected.pixels.size());
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < expected.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            difference += std::abs(picture.pixels[i][c] * factor - expected.pixels[i][c]);
            sum += expected.pixels[i][c];
        }
    EXPECT_GT(sum, 0.0) << what;
    EXPECT_LE(difference, share * sum) << what;
}

const Camera above = lookAt({25, 45, 70}, {0, 5, 0}, 45.0);

// A floor of 59 m, so that voxels of 64^3 are 1 m wide.
Scene floorOf59Metres() {
    Scene scene = emptyScene();
    scene.materials[0].baseColor = glm::vec4(0.6F, 0.6F, 0.6F, 1.0F);
    addQuad(scene, {-29.5, 0, -29.5}, {0, 0, 59}, {59, 0, 0});
    return scene;
}

Scene boxAndBall() {
    Scene scene = floorOf59Metres();
    addBox(scene, {12, 19, 12}, {6.3, 9.5, 2.3});
    addBall(scene, 6.0, {-12.2, 9.7, -3.1});
    return finished(std::move(scene));
}

TEST_P(Invariance, OfScaleAndPlace) {
    const Scene cornell = loadGltf(asset("cornell.glb"));
    const Image expected = picture(cornell, chooseLight(cornell), chooseCamera(cornell, ""));
    const auto expectSame = [&](const Scene& scene, const std::string& what) {
        expectAlike(picture(scene, chooseLight(scene), chooseCamera(scene, "")), expected, 0.005, what);
    };
    for (const char* name : {"cornell_1mm", "cornell_10km"})
        expectSame(loadGltf(asset(std::string(name) + ".glb")), name);
    const glm::dvec3 far(1e6, 1e6, -1e6);
    for (const bool byNode : {true, false}) {
        Scene scene = cornell;
        for (Instance& instance : scene.instances) {
            if (byNode)
                instance.worldFromObject[3] += glm::dvec4(far, 0.0);
            else
                scene.meshes[static_cast<std::size_t>(instance.mesh)].centre +=
                    glm::inverse(glm::dmat3(instance.worldFromObject)) * far;
        }
        scene.cameras[0].worldFromCamera[3] += glm::dvec4(far, 0.0);
        expectSame(finished(std::move(scene)), byNode ? "far nodes" : "far vertices");
    }
}

TEST_P(Invariance, OfAMirroringAndStretchingNode) {
    const glm::dvec3 scale(1.7, -0.9, 0.6), move(2.3, 14.2, 1.15);
    Scene placed = floorOf59Metres(), baked = floorOf59Metres();
    for (Scene* scene : {&placed, &baked}) {
        addBall(*scene, 5.0, {0, 0, 0});
        addBox(*scene, {4, 12, 5}, {-3, 0, 0.3});
    }
    for (std::size_t i = 1; i < placed.instances.size(); ++i) {
        placed.instances[i].worldFromObject = glm::scale(glm::translate(glm::dmat4(1.0), move), scale);
        Mesh& mesh = baked.meshes[i];
        for (Vertex& vertex : mesh.vertices) {
            vertex.position = glm::vec3(scale * (mesh.centre + glm::dvec3(vertex.position)) + move);
            vertex.normal = glm::normalize(vertex.normal / glm::vec3(scale));
        }
        mesh.centre = glm::dvec3(0.0);
        for (std::size_t k = 0; k < mesh.indices.size(); k += 3)
            std::swap(mesh.indices[k], mesh.indices[k + 1]);
    }
    const DirectionalLight light = lightFrom({0.5, 1.0, 0.3});
    expectAlike(picture(finished(placed), light, above), picture(finished(baked), light, above), 0.005,
                "mirrored");
}

// Slivers are narrower than a pixel of voxelization.
TEST_P(Invariance, OfAWallOfSlivers) {
    Scene slivers = floorOf59Metres(), whole = slivers;
    constexpr int count = 840;
    for (int i = 0; i < count; ++i)
        addQuad(slivers, {-15, i * 21.0 / count, -5.5}, {30, 0, 0}, {0, 21.0 / count, 0});
    addQuad(whole, {-15, 0, -5.5}, {30, 0, 0}, {0, 21, 0});
    const DirectionalLight light = lightFrom({-0.3, 1.0, 0.8});
    expectAlike(picture(finished(slivers), light, above), picture(finished(whole), light, above), 0.01,
                "slivers");
}

TEST_P(Invariance, OfASunInTheZenithAndOfItsStrength) {
    const Scene scene = boxAndBall();
    const Image zenith = picture(scene, lightFrom({0, 1, 0}), above);
    expectAlike(picture(scene, lightFrom({1.7e-4, 1, 0}), above), zenith, 0.01, "0.01 degrees beside");
    DirectionalLight bright = lightFrom({0, 1, 0});
    const float factor = bright.intensity / 1e5F;
    bright.intensity = 1e5F;
    expectAlike(picture(scene, bright, above), zenith, 0.002, "100,000 lux", factor);
}

}  // namespace
}  // namespace vct::test
