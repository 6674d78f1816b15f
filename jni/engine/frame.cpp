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
    draw({static_cast<Picture>(mode)}, camera, {.atMost = 1, .allBounces = true});
}

// A still picture: all those steps at once.
void Renderer::renderConverged(Mode mode, const Camera& camera) {
    draw({static_cast<Picture>(mode)}, camera, {.atMost = settings_.lightFrames, .allBounces = true});
}

// A part of the light alone; the first bounce of it, or all.
void Renderer::renderPart(Picture view, const Camera& camera, bool allBounces) {
    draw({view}, camera, {.atMost = settings_.lightFrames, .allBounces = allBounces});
}

// Several pictures of one moment, from the caller's G-buffer or from ours.
void Renderer::frame(const std::vector<Picture>& pictures, const Camera& camera,
                     const GBuffer::Targets* surface, bool converged) {
    draw(pictures, camera, {.atMost = converged ? settings_.lightFrames : 1, .allBounces = true}, surface);
}

void Renderer::draw(const std::vector<Picture>& pictures, const Camera& camera, LightSteps steps,
                    const GBuffer::Targets* given) {
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
    ShadowTextures shadow;
    for (const Picture picture : pictures)
        if (readsShadowMap(picture))
            shadow = shadowMap().update(scene_, now, picture, settings_.revoxelize, timer_);

    // Albedo, normal and depth of what the camera sees (thesis 4.3, "render data"): the caller's, or ours.
    const GBuffer::Targets surface =
        given != nullptr ? *given : timer_.time(Step::renderData, [&] { return gBuffer().draw(scene_); });

    bool lightIsUpToDate = false;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Picture picture = pictures[i];

        // The scene as voxels that are lit through the shadow map, and their mip levels (thesis 4.4 and 4.5).
        // With directional voxels also what their faces receive of each other's light, for ambient visibility
        // or for indirect light, whichever the picture shows; the latter comes nearer to its final value once
        // in a frame. Every picture that reads voxels reads the shadow map too.
        VoxelLight light;
        const bool showsTheSame = showsIndirectLight(picture) && std::exchange(lightIsUpToDate, true);
        if (readsVoxels(picture))
            light = voxels().update({.scene = scene_,
                                     .shadowMap = *shadow.depth,
                                     .now = now,
                                     .picture = picture,
                                     .lightSteps = showsTheSame ? 0 : steps.atMost,
                                     .allBounces = steps.allBounces,
                                     .remake = settings_.revoxelize},
                                    timer_);

        // The light of every pixel, or the part of it that the picture shows (thesis 4.6).
        if (i == shades_.size()) shades_.emplace_back(shaders_, settings_);
        timer_.time(Step::trace, [&] { shades_[i].draw(picture, surface, shadow, light); });
    }

    timer_.endFrame();
    gl::checkErrors("frame, mode or view " + std::to_string(pictures.front()));
    unfinished_ = false;
}

}  // namespace vct
