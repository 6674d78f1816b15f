// The frame, after the thesis of 2016 that the README names: depth as the sun sees it, surfaces as the camera
// sees them, the scene as voxels with their light, and what of all that reaches each pixel.
//
// Surfaces and the last pass are drawn in every frame. Shadow map and voxels follow from the scene's state
// alone, and never from the camera: each keeps the state that it was last made of, and makes nothing while
// that is the same. Both are made when a picture reads them for the first time.
#include <string>
#include <utility>

#include "engine/renderer.h"
#include "gl/debug.h"

namespace vct {

// A frame as an app draws it: what surfaces receive of each other's light comes one step nearer to its final
// value, where it stands still Settings::lightFrames steps after the last change.
void Renderer::frame(Mode mode, const Camera& camera) {
    draw(static_cast<Picture>(mode), camera, {.atMost = 1, .allBounces = true});
}

// A still picture: all those steps at once.
void Renderer::renderConverged(Mode mode, const Camera& camera) {
    draw(static_cast<Picture>(mode), camera, {.atMost = settings_.lightFrames, .allBounces = true});
}

// A part of the light alone; the first bounce of it, or all.
void Renderer::renderPart(Picture view, const Camera& camera, bool allBounces) {
    draw(view, camera, {.atMost = settings_.lightFrames, .allBounces = allBounces});
}

void Renderer::draw(Picture picture, const Camera& camera, LightSteps steps) {
    timer_.beginFrame();
    // A frame that threw never came to the end of this function: what it left of shadow map and voxels may be
    // half made, so they are made anew.
    if (std::exchange(unfinished_, true)) forgetWhatWasMade();

    // Moves what moves. The time is the voxelization's, for which the triangles of what moved are sorted by
    // the axis that they face most.
    if (nextPose_) timer_.timeOnCpu(Step::voxelize, [&] { scene_.setPose(*nextPose_); });
    nextPose_.reset();
    const SceneState now{scene_.placements(), light_.towardsLight};  // a copy
    uploadFrameUniforms(camera);

    // Depth as the sun sees it (thesis 4.2): for the direct light of pixels, and of voxels. Its coarser
    // levels are drawn where the picture shows a soft shadow.
    const gl::Texture* shadow = nullptr;
    if (readsShadowMap(picture))
        shadow = &shadowMap().update(scene_, now, picture, settings_.revoxelize, timer_);

    // Albedo, normal and depth of what the camera sees (thesis 4.3, "render data").
    const GBuffer::Targets surface = timer_.time(Step::renderData, [&] { return gBuffer_.draw(scene_); });

    // The scene as voxels that are lit through the shadow map, and their mip levels (thesis 4.4 and 4.5).
    // With directional voxels also what their faces receive of each other's light, for ambient visibility or
    // for indirect light, whichever the picture shows. Every picture that reads voxels reads the shadow map
    // too.
    VoxelLight light;
    if (readsVoxels(picture))
        light = voxels().update({.scene = scene_,
                                 .shadowMap = *shadow,
                                 .now = now,
                                 .picture = picture,
                                 .lightSteps = steps.atMost,
                                 .allBounces = steps.allBounces,
                                 .remake = settings_.revoxelize},
                                timer_);

    // The light of every pixel, or the part of it that the picture shows (thesis 4.6). The result is
    // output().
    timer_.time(Step::trace, [&] { shade_.draw(picture, surface, shadow, light); });

    timer_.endFrame();
    gl::checkErrors("frame, mode or view " + std::to_string(picture));
    unfinished_ = false;
}

}  // namespace vct
