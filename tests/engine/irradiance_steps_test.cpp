// What the faces received, from step to step: it comes to rest, nothing is computed then, and what changes is
// followed without a trace of what was.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "gl/call_log.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/playing_scene.h"
#include "support/received.h"
#include "support/scenes.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

std::set<std::string> groupsOf(const gl::CallLog& log) {
    std::set<std::string> groups;
    for (const auto& [group, calls] : gl::summarize(log.calls()).byGroup)
        groups.insert(group);
    return groups;
}

void expectAlike(const ReceivedFaces& a, const ReceivedFaces& right, double rms, const std::string& what) {
    const ReceivedDifference d = differenceOf(a, right);
    EXPECT_GT(d.common, 500U) << what;
    EXPECT_LE(d.rms, rms * d.mean) << what;
}

TEST(ReceivedLight, AStaticScenesStandsStillAndCostsNoDispatch) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    const Settings settings = mobileSettings();
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
    const Camera camera = chooseCamera(scene, "");
    for (const Output mode : {Output::ao, Output::gi, Output::giConeShadow}) {
        const int steps = mode == Output::giConeShadow ? 0 : settings.lightFrames;
        for (int frame = 0; frame < steps; ++frame) {
            const gl::CallLog log;
            renderer.render({{mode}, camera});
            EXPECT_EQ(groupsOf(log).count("gather"), 1U) << "step " << frame << " of " << outputName(mode);
        }
        renderer.render({{mode}, camera});
        const Image first = renderer.radiance();
        for (const Camera& from : {camera, lookAt({0.3, 0.2, 1.0}, {0, 0, 0}, 70), camera}) {
            const gl::CallLog log;
            renderer.render({{mode}, from});
            const gl::CallSummary calls = gl::summarize(log.calls());
            EXPECT_EQ(calls.dispatches, 0) << outputName(mode);
            EXPECT_EQ(calls.passes, (std::set<std::string>{"G-buffer", "cone trace"})) << outputName(mode);
        }
        EXPECT_TRUE(renderer.radiance().pixels == first.pixels) << outputName(mode);
        renderer.render({{mode}, camera, LightSteps::all});
        EXPECT_TRUE(renderer.radiance().pixels == first.pixels) << outputName(mode);
    }
}

TEST(ReceivedLight, AConvergedPictureIsThatOfAllItsFrames) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    Settings settings = mobileSettings();
    settings.lightFrames = 5;
    Renderer still = makeRenderer(context, scene, chooseLight(scene), settings);
    Renderer frames = makeRenderer(context, scene, chooseLight(scene), settings);
    const Camera camera = chooseCamera(scene, "");
    still.render({{Output::gi}, camera, LightSteps::all});
    for (int i = 0; i < settings.lightFrames; ++i)
        frames.render({{Output::gi}, camera});
    EXPECT_TRUE(readReceived(still) == readReceived(frames));
    // Bricks lie in the order of the list of faces, which atomics decide: their texels' coordinates are
    // rounded differently.
    const Image one = still.radiance(), other = frames.radiance();
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(one.pixels[i][c], other.pixels[i][c], 2e-3 * (0.1 + one.pixels[i][c])) << i;
}

TEST(ReceivedLight, OfAnyOrderOfTrianglesAndInstancesIsTheSame) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("courtyard.glb"));
    const Camera camera = chooseCamera(scene, "");
    Settings settings = mobileSettings();
    settings.size = glm::ivec2(96);
    const auto lit = [&](const Scene& of) {
        Renderer renderer = makeRenderer(context, of, chooseLight(of), settings);
        for (int step = 0; step < 3; ++step)
            renderer.render({{Output::gi}, camera});
        return std::make_pair(readReceived(renderer), renderer.radiance());
    };
    const auto [faces, picture] = lit(scene);
    ASSERT_GT(faces.size(), 10000U);
    Scene shuffled = scene;
    shuffleTriangles(shuffled, 1);
    const auto [otherFaces, otherPicture] = lit(shuffled);
    EXPECT_TRUE(otherFaces == faces);
    // Bricks lie elsewhere, and there the coordinates that the filter's weights follow from are rounded
    // otherwise.
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(otherPicture.pixels[i][c], picture.pixels[i][c],
                        0.005F * picture.pixels[i][c] + 1e-4F)
                << "pixel " << i;
}

double brightness(const ReceivedFaces& faces) {
    double sum = 0.0;
    for (const auto& [entry, face] : faces)
        sum += face.coverage * face.light.g;
    return sum;
}

// Memory is shortened, not lost; and at the end next to nothing is left of the light before.
TEST(ReceivedLight, FollowsALightThatTurns) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    const DirectionalLight light = chooseLight(scene);
    Settings settings = mobileSettings();
    settings.gather.coneBudget = 1 << 20;  // every face gathers in every step
    const Camera camera = chooseCamera(scene, "");
    Renderer renderer = makeRenderer(context, scene, light, settings);
    renderer.render({{Output::gi}, camera, LightSteps::all});
    const ReceivedFaces before = readReceived(renderer);
    DirectionalLight turned = light;
    const double angle = glm::radians(30.0);
    const glm::dvec3 l = light.directionToLight;
    turned.directionToLight = glm::normalize(glm::dvec3(l.x * std::cos(angle) + l.z * std::sin(angle), l.y,
                                                        l.z * std::cos(angle) - l.x * std::sin(angle)));
    Renderer fresh = makeRenderer(context, scene, turned, settings);
    fresh.render({{Output::gi}, camera, LightSteps::all});
    const ReceivedFaces right = readReceived(fresh);
    const double change = differenceOf(before, right).rms;
    renderer.setLightDirection(turned.directionToLight);
    double last = change;
    for (int frame = 1; frame <= settings.lightFrames; ++frame) {
        renderer.render({{Output::gi}, camera});
        const bool atPower = (frame & (frame - 1)) == 0;
        if (!atPower) continue;
        const ReceivedFaces now = readReceived(renderer);
        if (frame == 1) {
            // To 15 steps, and to three times as many along creases.
            int shortened = 0, shortest = 0;
            for (const auto& [entry, face] : now) {
                shortened += face.steps > 12.0 && face.steps < 50.0 ? 1 : 0;
                shortest += face.steps > 12.0 && face.steps < 20.0 ? 1 : 0;
            }
            EXPECT_GT(shortened, 99 * static_cast<int>(now.size()) / 100);
            EXPECT_GT(shortest, 85 * static_cast<int>(now.size()) / 100);
        }
        const double error = differenceOf(now, right).rms;
        EXPECT_LE(error, last) << frame;
        last = error;
    }
    // A twentieth of the change; of a room that has become dark, in which light goes round, more of what is
    // left there.
    EXPECT_LE(last, 0.055 * change);
    const gl::CallLog log;
    renderer.render({{Output::gi}, camera});
    EXPECT_EQ(gl::summarize(log.calls()).dispatches, 0);
}

// A box passes over the floor within a second and stands far from where it was.
Scene passingBox() {
    GltfBuilder builder = openFloor();
    addCube(builder, {0.8F, 0.8F, 0.8F}, {{"translation", {0, 1, -1.9}}, {"scale", {4, 2, 0.2}}});
    const int box = addCube(builder, {0.9F, 0.1F, 0.1F}, {{"translation", {-1, 0.55, 0.3}}});
    builder.animate(box, "translation", {0, 1}, {-1, 0.55F, 0.3F, 1.4F, 0.55F, -0.3F});
    return load(builder);
}

TEST(ReceivedLight, NothingIsLeftOfWhatMovedSixteenFramesLater) {
    const Context context = openContext(Backend::egl);
    const Scene scene = passingBox();
    const Settings settings = mobileSettings();
    for (const Output mode : {Output::gi, Output::ao}) {
        const GatherPurpose of = mode == Output::ao ? GatherPurpose::occlusion : GatherPurpose::light;
        PlayingScene stage(context, scene, settings);
        stage.convergedAt(0.0, mode);
        for (int frame = 1; frame <= 30; ++frame)
            stage.frameAt(frame / 30.0, mode);
        const ReceivedFaces moving = readReceived(stage.renderer(), of);
        for (int frame = 0; frame < 16; ++frame)
            stage.frameAt(1.0, mode);
        const Scene frozen = frozenAt(scene, 1.0);
        PlayingScene fresh(context, frozen, settings);
        fresh.convergedAt(0.0, mode);
        const ReceivedFaces right = readReceived(fresh.renderer(), of);
        // What each face remembers by itself: pixels see it together with its block's.
        expectAlike(moving, right, 0.65, std::string(outputName(mode)) + ", while it moves");
        ASSERT_EQ(settings.lightFrames, 16);
        expectAlike(readReceived(stage.renderer(), of), right, 0.02,
                    std::string(outputName(mode)) + ", 16 frames later");
    }
}

// Voxels that are made anew in the same light find it where they are.
TEST(ReceivedLight, StaysWhereVoxelsAreMadeAnew) {
    const Context context = openContext(Backend::egl);
    for (const Scene& scene : {loadGltf(asset("cornell.glb")), passingBox()}) {
        Settings settings = mobileSettings();
        settings.revoxelize = true;
        PlayingScene stage(context, scene, settings);
        stage.renderer().render({{Output::gi}, chooseCamera(scene, ""), LightSteps::all});
        const ReceivedFaces before = readReceived(stage.renderer());
        for (int frame = 0; frame < 20; ++frame)
            stage.frame();
        const ReceivedFaces after = readReceived(stage.renderer());
        ASSERT_EQ(after.size(), before.size());
        int kept = 0;
        for (const auto& [entry, face] : after)
            kept += face.steps > 8.0 ? 1 : 0;
        EXPECT_GT(kept, 99 * static_cast<int>(after.size()) / 100) << "of " << after.size();
        // Of what can move, faces begin with what pixels looked up, together with its block's light.
        const bool moves = !scene.animation.channels.empty();
        expectAlike(after, before, moves ? 0.3 : 0.15, scene.path + " after 20 frames");
        EXPECT_NEAR(brightness(after) / brightness(before), 1.0, moves ? 0.03 : 0.025) << scene.path;
    }
}

// Light is injected once, without irradiance.
TEST(ReceivedLight, OcclusionLightsNoFace) {
    const Context context = openContext(Backend::egl);
    const Scene scene = passingBox();
    PlayingScene stage(context, scene, mobileSettings());
    stage.frameAt(0.0, Output::gi);
    stage.frameAt(0.1, Output::ao);
    const gl::CallLog log;
    stage.frameAt(0.2, Output::ao);
    EXPECT_EQ(groupsOf(log).count("gather"), 1U);
    EXPECT_EQ(groupsOf(log).count("begin light step"), 1U);
    EXPECT_EQ(groupsOf(log).count("inject"), 1U);
}

// Under the floor a box grows to twenty times its voxels: what there is room for grows, and what stands still
// keeps its memory and its light, which has not changed.
TEST(ReceivedLight, KeepsItsMemoryWhereItNeedsMoreRoom) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    addCube(builder, {0.8F, 0.8F, 0.8F}, {{"translation", {0, 1, -1.9}}, {"scale", {4, 2, 0.2}}});
    const int box =
        addCube(builder, {0.9F, 0.6F, 0.1F}, {{"translation", {0, -1.2, 0}}, {"scale", {0.1, 0.1, 0.1}}});
    builder.animate(box, "scale", {0, 1}, {0.1F, 0.1F, 0.1F, 3.8F, 2.0F, 3.9F});
    const Scene scene = load(builder);
    PlayingScene stage(context, scene, mobileSettings());
    stage.convergedAt(0.0);
    const std::size_t received = bytesOf(stage.renderer().resources(), "face irradiance"),
                      bricks = bytesOf(stage.renderer().resources(), "irradiance");
    const ReceivedFaces before = readReceived(stage.renderer());
    for (const double seconds : {0.3, 0.6, 1.0})
        stage.frameAt(seconds);
    EXPECT_GT(bytesOf(stage.renderer().resources(), "face irradiance"), received);
    EXPECT_GT(bytesOf(stage.renderer().resources(), "irradiance"), bricks);
    const ReceivedFaces after = readReceived(stage.renderer());
    EXPECT_GT(after.size(), before.size() + 1000);
    int kept = 0;
    for (const auto& [entry, face] : before) {
        const auto now = after.find(entry);
        // Of a face that begins anew: four.
        kept += now != after.end() && now->second.steps > 8.0 ? 1 : 0;
    }
    EXPECT_GT(kept, 9 * static_cast<int>(before.size()) / 10) << "of " << before.size();
    expectAlike(after, before, 0.6, "after it has grown");  // three frames' noise
    const ReceivedDifference d = differenceOf(after, before);
    EXPECT_NEAR(d.bias / d.mean, 0.0, 0.06);
    expectFreshLight(stage, context, scene, mobileSettings(), 1.0);
}

}  // namespace
}  // namespace vct::test
