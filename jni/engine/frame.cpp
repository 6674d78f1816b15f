// The frame. Depth as the sun sees it, surfaces as the camera sees them, the scene as voxels with their
// light, and what of all that reaches each pixel. What has not changed since the last frame is not made
// again.
#include <utility>

#include "engine/renderer.h"
#include "gl/debug.h"

namespace vct {

void Renderer::frame(Mode mode, const Camera& camera) {
    draw(static_cast<Picture>(mode), camera, {1, true});
}

void Renderer::renderConverged(Mode mode, const Camera& camera) {
    draw(static_cast<Picture>(mode), camera, {settings_.lightFrames, true});
}

void Renderer::renderPart(Picture view, const Camera& camera, bool allBounces) {
    draw(view, camera, {settings_.lightFrames, allBounces});
}

void Renderer::draw(Picture picture, const Camera& camera, LightSteps steps) {
    timer_.beginFrame();
    if (std::exchange(unfinished_, true)) forgetWhatWasMade();

    // Where everything is. Sorting the triangles of what moves by their axis takes the longest of it.
    if (nextPose_) timer_.timeOnCpu(Step::voxelize, [&] { scene_.setPose(*nextPose_); });
    nextPose_.reset();
    const SceneState now{scene_.placements(), light_.towardsLight};
    uploadFrameUniforms(camera);

    // Depth as the sun sees it (thesis 4.2): for direct light here, and for light in the voxels.
    const gl::Texture* shadow = nullptr;
    if (readsShadowMap(picture))
        shadow = &shadowMap().update(scene_, now, picture, settings_.revoxelize, timer_);

    // Albedo, normal and depth of what the camera sees (thesis 4.3).
    const GBuffer::Targets surface = timer_.time(Step::renderData, [&] { return gBuffer_.draw(scene_); });

    // Voxels, lit through the shadow map, their mip levels, and what surfaces receive of each other's light
    // (thesis 4.4 and 4.5; directional/irradiance.h).
    VoxelLight light;
    if (readsVoxels(picture))
        light = voxels().update(
            {scene_, *shadow, now, picture, steps.atMost, steps.allBounces, settings_.revoxelize}, timer_);

    // Every pixel's direct and indirect light (thesis 4.6).
    timer_.time(Step::trace, [&] { shade_.draw(picture, surface, shadow, light); });

    timer_.endFrame();
    gl::checkErrors("frame, mode or view " + std::to_string(picture));
    unfinished_ = false;
}

}  // namespace vct
