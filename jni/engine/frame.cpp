// The frame, after the thesis of 2016 that the README names: depth as the lights see it, surfaces as the
// camera sees them, the scene as voxels with their light, and what of all that reaches each pixel.
//
// The last pass is drawn in every frame, and so are surfaces where the caller brings none. Shadow maps and
// voxels follow from the scene's state alone, never from the camera: each is made when a picture reads it for
// the first time, keeps the state that it was made of, and is not made again while the state is the same
// (unless Settings::revoxelize asks for it, to measure that).
#include <string>

#include "engine/renderer.h"
#include "gl/debug.h"

namespace vct {

// A frame as an app draws it: the light that surfaces receive of each other takes one step towards its final
// value, which it reaches Settings::lightFrames steps after the last change.
void Renderer::frame(Mode mode, const Camera& camera) {
    draw({static_cast<Picture>(mode)}, camera, {.atMost = 1, .allBounces = true});
}

// A still picture: takes as many of those steps as are left.
void Renderer::renderConverged(Mode mode, const Camera& camera) {
    draw({static_cast<Picture>(mode)}, camera, {.atMost = settings_.lightFrames, .allBounces = true});
}

// Draws a part of the light alone, of the first bounce or of all.
void Renderer::renderPart(Picture view, const Camera& camera, bool allBounces) {
    draw({view}, camera, {.atMost = settings_.lightFrames, .allBounces = allBounces});
}

// Draws several pictures of one moment, from the caller's G-buffer or from ours.
void Renderer::frame(const std::vector<Picture>& pictures, const Camera& camera,
                     const GBuffer::Targets* surface, bool converged) {
    draw(pictures, camera, {.atMost = converged ? settings_.lightFrames : 1, .allBounces = true}, surface);
}

// `pictures`: at least one. `callersSurface`: null where the G-buffer is ours.
void Renderer::draw(const std::vector<Picture>& pictures, const Camera& camera, LightSteps steps,
                    const GBuffer::Targets* callersSurface) {
    timer_.beginFrame();
    // A frame that threw never came to the end of this function: what it left of shadow maps and voxels may
    // be half made, so they are made anew.
    if (unfinished_) forgetWhatWasMade();
    unfinished_ = true;

    // Moves what moves. That counts as voxelization, because its longest part is for that: triangles of what
    // moved are sorted by the axis that they face most.
    if (nextPose_) timer_.timeOnCpu(Step::voxelize, [&] { setPoseNow(*nextPose_); });
    nextPose_.reset();
    const SceneState now = state();
    uploadFrameUniforms(camera);

    // Depth as the sun sees it (thesis 4.2), and as other lights do, for the direct light of pixels and of
    // voxels. Where a picture shows the sun's soft shadow its map has moments too.
    DirectLight direct{{}, punctualLights_ ? &*punctualLights_ : nullptr};
    for (const Picture picture : pictures)
        if (readsShadowMap(picture))
            direct.sun = shadowMap().update(scene_, now, picture, settings_.revoxelize, timer_);
    if (punctualLights_) punctualLights_->update(scene_, now, settings_.revoxelize, timer_);

    // Albedo, normal and depth of what the camera sees (thesis 4.3, "render data").
    const GBuffer::Targets surface =
        callersSurface != nullptr ? *callersSurface
                                  : timer_.time(Step::renderData, [&] { return gBuffer().draw(scene_); });

    bool steppedInThisFrame = false;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Picture picture = pictures[i];

        // The scene as voxels that are lit through the shadow maps, and their mip levels (thesis 4.4
        // and 4.5). Faces of directional voxels also gather what a picture shows of their surroundings: the
        // light that other faces send them, or how open they are. Of several pictures of that light only the
        // first one takes its steps. (A picture that reads voxels reads the shadow map too, so there is one.)
        VoxelLight light;
        if (readsVoxels(picture)) {
            const bool showsLight = showsIndirectLight(picture);
            light = voxels().update({.scene = scene_,
                                     .light = direct,
                                     .now = now,
                                     .picture = picture,
                                     .lightSteps = showsLight && steppedInThisFrame ? 0 : steps.atMost,
                                     .allBounces = steps.allBounces,
                                     .remake = settings_.revoxelize},
                                    timer_);
            steppedInThisFrame = steppedInThisFrame || showsLight;
        }

        // The light of every pixel, or the part of it that the picture shows (thesis 4.6), into a texture of
        // the picture's own: Renderer::output().
        if (i == shades_.size()) shades_.emplace_back(shaders_, sources(), settings_);
        timer_.time(Step::trace, [&] { shades_[i].draw(picture, surface, direct, light); });
    }

    timer_.endFrame();
    gl::checkErrors("frame, picture " + std::to_string(pictures.front()));
    unfinished_ = false;
}

}  // namespace vct
