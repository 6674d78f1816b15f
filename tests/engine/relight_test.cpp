// Voxels that are lit anew where only the light moved, against those of a renderer that never saw
// another light.
#include <gtest/gtest.h>

#include <algorithm>

#include "gl/call_log.h"
#include "scene/camera.h"
#include "support/grids.h"
#include "support/moving_scenes.h"
#include "support/renderers.h"
#include "support/scenes.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

// By day, low, level with the floor, from below, along axes, and back.
const glm::dvec3 sun(0.4, 1.0, 0.3);
const std::vector<glm::dvec3> lights{{-0.7, 0.4, 0.2}, {1, 0, 0.1}, {0, -1, 0}, {0, 1, 0}, sun};

class Relight : public testing::Test {
  protected:
    Relight() : context_(openContext(Backend::egl)), settings_(mobileSettings()) {}

    Renderer rendererOf(const Scene& scene, const glm::dvec3& towardsLight) const {
        return makeRenderer(context_, scene, lightFrom(towardsLight), settings_);
    }
    void expectFresh(Renderer& renderer, const Scene& scene, const glm::dvec3& towardsLight, Output mode,
                     const std::string& what) const {
        const Camera camera = chooseCamera(scene, "");
        renderer.setLightDirection(glm::normalize(towardsLight));
        renderer.render({{mode}, camera});
        Renderer fresh = rendererOf(scene, towardsLight);
        fresh.render({{mode}, camera});
        // The shadow map's mode has none.
        if (fresh.directional() != nullptr) expectSameGrid(gridOf(renderer), gridOf(fresh), what);
    }

    Context context_;
    Settings settings_;
};

// Textures, holes, emission, both sides: the courtyard has all of them. A mode that lights no face with what
// it received shows the radiance of every level's faces too; what faces received remembers the light before
// (irradiance_steps_test.cpp).
TEST_F(Relight, EveryLightLeavesTheVoxelsOfAFreshRenderer) {
    const Scene scene = loadGltf(asset("courtyard.glb"));
    for (const Output mode : {Output::gi, Output::ao}) {
        Renderer renderer = rendererOf(scene, sun);
        renderer.render({{mode}, chooseCamera(scene, "")});
        const Grid before = gridOf(renderer);
        EXPECT_EQ(before.received, mode == Output::gi);
        const std::size_t bytesBefore = bytesOf(renderer.resources());
        for (std::size_t i = 0; i < lights.size(); ++i)
            expectFresh(renderer, scene, lights[i], mode, "light " + std::to_string(i));
        expectSameGrid(before, gridOf(renderer), "back again");
        EXPECT_EQ(bytesOf(renderer.resources()), bytesBefore);
        renderer.setLightDirection(lights[0]);
        renderer.render({{mode}, chooseCamera(scene, "")});
        EXPECT_FALSE(gridOf(renderer).sums == before.sums) << "the light changes nothing";
    }
}

TEST_F(Relight, AfterOtherModesAndPosesToo) {
    GltfBuilder builder = openFloor();
    const int box =
        addCube(builder, {0.9F, 0.2F, 0.1F}, {{"translation", {0, 0.6, 0}}, {"scale", {0.6, 0.6, 0.6}}});
    builder.animate(box, "translation", {0, 1}, {0, 0.6F, 0, 0.8F, 0.9F, 0.4F});
    const Scene scene = load(builder);
    const Scene frozen = frozenAt(scene, 0.5);
    Renderer renderer = rendererOf(scene, sun);
    const Camera camera = chooseCamera(scene, "");
    renderer.render({{Output::gi}, camera});
    renderer.setPose(poseAt(scene.animation, 0.5));
    renderer.render({{Output::gi}, camera});
    std::size_t light = 0;
    for (const Output mode : {Output::gi, Output::ao, Output::gi, Output::shadowMap, Output::giConeShadow}) {
        expectFresh(renderer, frozen, lights[light], mode, outputName(mode) + (" " + std::to_string(light)));
        ++light;
    }
}

TEST_F(Relight, ItsProgramsAreMadeWhenTheLightMoves) {
    const Scene scene = load(openFloor());
    const Camera camera = chooseCamera(scene, "");
    const gl::CallLog log;
    Renderer renderer = rendererOf(scene, sun);
    const auto made = [&] {
        const std::vector<gl::Call>& calls = log.calls();
        return std::count_if(calls.begin(), calls.end(), [&](const gl::Call& call) {
            return std::string(call.name) == "ObjectLabel" && call.text == "directional/clear_radiance";
        });
    };
    renderer.render({{Output::gi}, camera});
    renderer.render({{Output::gi}, lookAt({0, 2, 3}, {0, 0, 0}, 40)});
    EXPECT_EQ(made(), 0);
    for (const glm::dvec3& light : {lights[0], lights[1]}) {
        renderer.setLightDirection(light);
        renderer.render({{Output::gi}, camera});
        EXPECT_EQ(made(), 1);
    }
}

}  // namespace
}  // namespace vct::test
