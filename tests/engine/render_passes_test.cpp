// The render passes of frames: a tile-based GPU reads no attachment at the start of a pass, and writes back
// only those that somebody reads.
#include <gtest/gtest.h>

#include "lab/voxel_view.h"
#include "scene/camera.h"
#include "support/punctual_light.h"
#include "support/render_passes.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

// A glossy box that glows on a floor, under a point, a spot and the sun: frames of it have every target and
// map.
Scene sceneWithEverything() {
    Scene scene = emptyScene();
    scene.materials.resize(2);
    scene.materials[1].emissive = glm::vec3(2.0F);
    scene.materials[1].roughness = 0.3F;
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, 0);
    addBox(scene, {0.5, 0.5, 0.5}, {0, 0.25, 0}, 1);
    scene = finished(std::move(scene));
    scene.punctualLights = {punctualLightAt(PunctualLight::Type::point, {0.3, 1.2, 0.5}, {0, 0, 0}),
                            punctualLightAt(PunctualLight::Type::spot, {-0.5, 1.0, 0.2}, {0, 0, 0})};
    return scene;
}

TEST(RenderPasses, OfFramesReadAndWriteNoAttachmentThatNobodyNeeds) {
    const Context context = openContext(Backend::egl);
    for (const char* preset : {"thesis", "mobile"}) {
        gl::CallLog log;
        Settings settings = presetSettings(preset);
        settings.grid = 64;
        settings.size = glm::ivec2(32);
        settings.shadowMapSize = 64;
        settings.revoxelize = true;
        settings.lightRadius = 0.1F;
        Renderer renderer = makeRenderer(context, sceneWithEverything(), lightFrom({1, 2, 1}), settings);
        for (int frame = 0; frame < 2; ++frame)
            renderer.render({{Output::giConeShadow}, lookAt({0, 2, 3}, {0, 0, 0}, 40)});
        VoxelView view(renderer.shaders(), settings.size);
        const gl::Texture& voxels = view.draw(renderer.occupancy(), 0);

        const RenderPasses passes = renderPassesOf(log.calls(), {renderer.output().name(), voxels.name()});
        EXPECT_EQ(passes.loaded, std::set<std::string>{}) << preset;
        EXPECT_EQ(passes.unread, std::set<std::string>{}) << preset;
        // In each frame a shadow map, 7 maps of lights, the G-buffer and the picture.
        EXPECT_GE(passes.count, 2 * 10 + 1) << preset;
    }
}

// The log's calls have no driver to answer to.
TEST(RenderPasses, TellWhichAttachmentIsReadOrWrittenForNobody) {
    const gl::Call color{
        "FramebufferTexture2D", {GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 8, 0}, ""};
    const gl::Call depth{
        "FramebufferTexture2D", {GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 9, 0}, ""};
    const gl::Call bind{"BindFramebuffer", {GL_FRAMEBUFFER, 1}, ""};
    const gl::Call clearColor{"ClearBufferfv", {GL_COLOR, 0, 0}, ""};
    const gl::Call clearDepth{"ClearBufferfv", {GL_DEPTH, 0, 0}, ""};
    const gl::Call draw{"DrawArrays", {GL_TRIANGLES, 0, 3}, ""};
    const gl::Call invalidate{"InvalidateFramebuffer", {GL_FRAMEBUFFER, 1, 0}, "", {GL_DEPTH_ATTACHMENT}};
    const gl::Call scissor{"Enable", {GL_SCISSOR_TEST}, ""};
    using Names = std::set<std::string>;

    RenderPasses passes = renderPassesOf({bind, color, depth, clearColor, draw}, {8});
    EXPECT_EQ(passes.loaded, Names{"no group: depth"});
    EXPECT_EQ(passes.unread, Names{"no group: depth"});
    EXPECT_EQ(passes.count, 1);

    passes = renderPassesOf({bind, color, depth, clearColor, clearDepth, draw, invalidate}, {8});
    EXPECT_EQ(passes.loaded, Names{});
    EXPECT_EQ(passes.unread, Names{});

    // A second pass has to clear again, and a part of an attachment is not enough.
    passes = renderPassesOf({bind, color, clearColor, draw, bind, draw}, {8});
    EXPECT_EQ(passes.loaded, Names{"no group: color 0"});
    passes = renderPassesOf({bind, color, scissor, clearColor, draw}, {8});
    EXPECT_EQ(passes.loaded, Names{"no group: color 0"});
}

}  // namespace
}  // namespace vct::test
