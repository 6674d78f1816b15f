// The faces' irradiance from step to step: it converges, then no light pass runs, and it follows changes
// until no trace of the earlier light is left.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/face_irradiance.h"
#include "support/gl_spy.h"
#include "support/playing_scene.h"
#include "support/scenes.h"
#include "support/steps.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

// Compute passes while it lives.
struct DispatchCount {
    int count = 0;
    const GlSpy<&gl::DispatchCompute> direct{[this](GLuint, GLuint, GLuint) { ++count; }};
    const GlSpy<&gl::DispatchComputeIndirect> indirect{[this](GLintptr) { ++count; }};
};

void expectAlike(const IrradianceByFace& a, const IrradianceByFace& right, double rms,
                 const std::string& what) {
    const IrradianceDifference d = differenceOf(a, right);
    EXPECT_GT(d.common, 500U) << what;
    EXPECT_LE(d.rms, rms * d.mean) << what;
}

TEST(Irradiance, InAStaticSceneConvergesToPicturesEqualToTheBitWithoutADispatch) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    const Settings settings = mobileSettings();
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
    const Camera camera = chooseCamera(scene, "");
    for (const Output mode : {Output::ao, Output::gi, Output::giConeShadow}) {
        // All modes show what the same steps gather.
        const int frames = mode == Output::ao ? settings.lightFrames : 0;
        for (int i = 0; i < frames; ++i) {
            const std::string steps = stepsOf(renderer, [&] { renderer.render({{mode}, camera}); });
            EXPECT_NE(steps.find("irradiance"), std::string::npos)
                << "frame " << i << " of " << outputName(mode);
        }
        renderer.render({{mode}, camera});
        const Image first = renderer.radiance();
        const DispatchCount dispatches;
        for (const Camera& from : {camera, lookAt({0.3, 0.2, 1.0}, {0, 0, 0}, 70), camera})
            renderer.render({{mode}, from});
        EXPECT_TRUE(renderer.radiance().pixels == first.pixels) << outputName(mode);
        renderer.render({{mode}, camera, LightSteps::all});
        EXPECT_TRUE(renderer.radiance().pixels == first.pixels) << outputName(mode);
        EXPECT_EQ(dispatches.count, 0) << outputName(mode);
    }
}

TEST(Irradiance, DoesNotDependOnTheOrderOfTrianglesAndInstances) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("courtyard.glb"));
    const Camera camera = chooseCamera(scene, "");
    Settings settings = mobileSettings();
    settings.size = glm::ivec2(96);
    const auto lit = [&](const Scene& of) {
        Renderer renderer = makeRenderer(context, of, chooseLight(of), settings);
        for (int step = 0; step < 3; ++step)
            renderer.render({{Output::gi}, camera});
        return std::make_pair(readIrradiance(renderer), renderer.radiance());
    };
    const auto [faces, picture] = lit(scene);
    ASSERT_GT(faces.size(), 10000U);
    Scene shuffled = scene;
    shuffleTriangles(shuffled, 1);
    const auto [otherFaces, otherPicture] = lit(shuffled);
    ASSERT_EQ(otherFaces.size(), faces.size());
    // The parts of compact emitters are sums over their triangles, which round differently in another order,
    // so a ray to a part may end at another edge.
    int differing = 0;
    for (const auto& [entry, face] : faces) {
        const FaceIrradiance& other = otherFaces.at(entry);
        if (other == face) continue;
        ++differing;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(other.light[c], face.light[c], 0.003 * face.light[c] + 1e-5);
    }
    EXPECT_LE(differing, 50);
    // The bricks have other places, where texel coordinates round differently. Where a pixel has hardly a
    // texel, that decides whether the look-up tries other positions.
    int moved = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = picture.pixels[i][c];
            const float difference = std::abs(otherPicture.pixels[i][c] - value);
            ASSERT_LE(difference, 0.5F * value + 1e-4F) << "pixel " << i;
            moved += difference > 0.005F * value + 1e-4F ? 1 : 0;
        }
    EXPECT_LE(moved, 15);
}

double brightness(const IrradianceByFace& faces) {
    double sum = 0.0;
    for (const auto& [entry, face] : faces)
        sum += face.coverage * face.light.g;
    return sum;
}

// Faces have an eighth of their rays then, and the first four bounces of those.
TEST(Irradiance, LightsTheFirstPictureAsBrightAsTheLast) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    const Settings settings = mobileSettings();
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
    const Camera camera = chooseCamera(scene, "");
    const auto brightnessAfter = [&](int frames) {
        for (int i = 0; i < frames; ++i)
            renderer.render({{Output::gi}, camera});
        double sum = 0.0;
        for (const glm::vec3& pixel : renderer.radiance().pixels)
            sum += pixel.g;
        return sum;
    };
    const double first = brightnessAfter(1), last = brightnessAfter(settings.lightFrames);
    EXPECT_NEAR(first / last, 1.0, 0.04);
}

TEST(Irradiance, FollowsALightThatTurns) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    const DirectionalLight light = chooseLight(scene);
    Settings settings = mobileSettings();
    const Camera camera = chooseCamera(scene, "");
    Renderer renderer = makeRenderer(context, scene, light, settings);
    renderer.render({{Output::gi}, camera, LightSteps::all});
    const IrradianceByFace before = readIrradiance(renderer);
    DirectionalLight turned = light;
    const double angle = glm::radians(30.0);
    const glm::dvec3 l = light.directionToLight;
    turned.directionToLight = glm::normalize(glm::dvec3(l.x * std::cos(angle) + l.z * std::sin(angle), l.y,
                                                        l.z * std::cos(angle) - l.x * std::sin(angle)));
    Renderer fresh = makeRenderer(context, scene, turned, settings);
    fresh.render({{Output::gi}, camera, LightSteps::all});
    const IrradianceByFace right = readIrradiance(fresh);
    const double change = differenceOf(before, right).rms;
    renderer.setLightDirection(turned.directionToLight);
    double last = change;
    for (int frame = 1; frame <= settings.lightFrames; ++frame) {
        renderer.render({{Output::gi}, camera});
        if ((frame & (frame - 1)) != 0) continue;
        const double error = differenceOf(readIrradiance(renderer), right).rms;
        EXPECT_LE(error, last) << frame;
        last = error;
    }
    EXPECT_LE(last, 0.055 * change);
    const DispatchCount dispatches;
    renderer.render({{Output::gi}, camera});
    EXPECT_EQ(dispatches.count, 0);
}

// A box passes over the floor within a second and stands far from where it was.
Scene passingBox() {
    GltfBuilder builder = openFloor();
    addCube(builder, {0.8F, 0.8F, 0.8F}, {{"translation", {0, 1, -1.9}}, {"scale", {4, 2, 0.2}}});
    const int box = addCube(builder, {0.9F, 0.1F, 0.1F}, {{"translation", {-1, 0.55, 0.3}}});
    builder.animate(box, "translation", {0, 1}, {-1, 0.55F, 0.3F, 1.4F, 0.55F, -0.3F});
    return load(builder);
}

TEST(Irradiance, HasNoTraceOfAMovedBoxSixteenFramesLater) {
    const Context context = openContext(Backend::egl);
    const Scene scene = passingBox();
    const Settings settings = mobileSettings();
    for (const Output mode : {Output::gi, Output::ao}) {
        PlayingScene stage(context, scene, settings);
        stage.convergedAt(0.0, mode);
        for (int frame = 1; frame <= 30; ++frame)
            stage.frameAt(frame / 30.0, mode);
        const IrradianceByFace moving = readIrradiance(stage.renderer());
        for (int frame = 0; frame < 16; ++frame)
            stage.frameAt(1.0, mode);
        const Scene frozen = frozenAt(scene, 1.0);
        PlayingScene fresh(context, frozen, settings);
        fresh.convergedAt(0.0, mode);
        const IrradianceByFace right = readIrradiance(fresh.renderer());
        // These are single faces; pixels see the mean with the face's block.
        expectAlike(moving, right, 0.75, std::string(outputName(mode)) + ", while it moves");
        ASSERT_EQ(settings.lightFrames, 16);
        expectAlike(readIrradiance(stage.renderer()), right, 0.03,
                    std::string(outputName(mode)) + ", 16 frames later");
    }
}

TEST(Irradiance, StaysWhenVoxelsAreRebuiltInTheSameLight) {
    const Context context = openContext(Backend::egl);
    for (const Scene& scene : {loadGltf(asset("cornell.glb")), passingBox()}) {
        Settings settings = mobileSettings();
        settings.revoxelize = true;
        PlayingScene stage(context, scene, settings);
        stage.renderer().render({{Output::gi}, chooseCamera(scene, ""), LightSteps::all});
        const IrradianceByFace before = readIrradiance(stage.renderer());
        for (int frame = 0; frame < 20; ++frame)
            stage.frame();
        const IrradianceByFace after = readIrradiance(stage.renderer());
        ASSERT_EQ(after.size(), before.size());
        int kept = 0;
        for (const auto& [entry, face] : after)
            kept += face.rays >= 16 ? 1 : 0;
        EXPECT_GT(kept, 99 * static_cast<int>(after.size()) / 100) << "of " << after.size();
        const bool moves = !scene.animation.channels.empty();
        expectAlike(after, before, moves ? 0.3 : 0.18, scene.path + " after 20 frames");
        EXPECT_NEAR(brightness(after) / brightness(before), 1.0, moves ? 0.03 : 0.025) << scene.path;
    }
}

// A box under the floor grows to twenty times its voxels. The capacity grows; static faces keep their hits
// and their light, which has not changed.
TEST(Irradiance, KeepsItsHitsWhenItsBuffersGrow) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    addCube(builder, {0.8F, 0.8F, 0.8F}, {{"translation", {0, 1, -1.9}}, {"scale", {4, 2, 0.2}}});
    const int box =
        addCube(builder, {0.9F, 0.6F, 0.1F}, {{"translation", {0, -1.2, 0}}, {"scale", {0.1, 0.1, 0.1}}});
    builder.animate(box, "scale", {0, 1}, {0.1F, 0.1F, 0.1F, 3.8F, 2.0F, 3.9F});
    const Scene scene = load(builder);
    PlayingScene stage(context, scene, mobileSettings());
    stage.convergedAt(0.0);
    const std::size_t faces = bytesOf(stage.renderer().resources(), "face irradiance");
    const IrradianceByFace before = readIrradiance(stage.renderer());
    for (const double seconds : {0.3, 0.6, 1.0})
        stage.frameAt(seconds);
    EXPECT_GT(bytesOf(stage.renderer().resources(), "face irradiance"), faces);
    const IrradianceByFace after = readIrradiance(stage.renderer());
    EXPECT_GT(after.size(), before.size() + 1000);
    int kept = 0;
    for (const auto& [entry, face] : before) {
        const auto now = after.find(entry);
        kept += now != after.end() && now->second.rays >= 64 ? 1 : 0;
    }
    EXPECT_GT(kept, 9 * static_cast<int>(before.size()) / 10) << "of " << before.size();
    expectAlike(after, before, 0.7, "after it has grown");  // three frames' noise
    const IrradianceDifference d = differenceOf(after, before);
    EXPECT_NEAR(d.bias / d.mean, 0.0, 0.06);
    expectFreshLight(stage, context, scene, mobileSettings(), 1.0);
}

}  // namespace
}  // namespace vct::test
