// The frame, after the thesis of 2016 that the README names: depth as the lights see it, surfaces as the
// camera sees them, the scene as voxels with their light, and what of all that reaches each pixel.
//
// The last pass runs in every frame, and so does the G-buffer where the caller brings none. Shadow maps and
// voxels follow from the scene's state alone, never from the camera: each is made when an output reads it for
// the first time, keeps the state that it was made for, and is not rebuilt while the state is the same
// (unless Settings::revoxelize asks for it, to measure that).
#include <algorithm>
#include <limits>
#include <string>

#include "engine/renderer.h"
#include "gl/debug.h"

namespace vct {

void Renderer::render(const RenderRequest& request) {
    timer_.beginFrame();
    // A frame that threw may have left shadow maps and voxels half made.
    if (lastFrameFailed_) invalidateCaches();
    lastFrameFailed_ = true;

    // Apply the pose. It is timed as voxelization because re-sorting the moved triangles dominates.
    if (nextPose_) timer_.timeOnCpu(Step::voxelize, [&] { applyPose(*nextPose_); });
    nextPose_.reset();
    const SceneState now = state();
    uploadFrameUniforms(request.camera);
    if (std::any_of(request.outputs.begin(), request.outputs.end(),
                    [](Output output) { return reads(output).voxels; }))
        voxels().prepare(scene_);

    // Depth as the sun sees it (thesis 4.2), and as other lights do, for the direct light of pixels and of
    // voxels. The sun's soft shadow also reads moments of its map.
    DirectLight direct{{}, punctualLights_ ? &*punctualLights_ : nullptr};
    for (const Output output : request.outputs)
        if (reads(output).shadowMap())
            direct.sun = shadowMap().update(scene_, now, output, settings_.revoxelize, timer_);
    if (punctualLights_) punctualLights_->update(scene_, now, settings_.revoxelize, timer_);

    // Albedo, normal and depth of what the camera sees (thesis 4.3, "render data").
    const GBuffer::Targets surface =
        request.surface != nullptr ? *request.surface
                                   : timer_.time(Step::renderData, [&] { return gBuffer().draw(scene_); });

    const int lightSteps = request.lightSteps == LightSteps::all ? std::numeric_limits<int>::max() : 1;
    bool indirectTookSteps = false;
    for (std::size_t i = 0; i < request.outputs.size(); ++i) {
        const Output output = request.outputs[i];

        // The scene as voxels that are lit through the shadow maps, and their mip levels (thesis 4.4
        // and 4.5). Faces gather indirect light or ambient occlusion, whichever the output needs. Of
        // several outputs of indirect light only the first one takes the frame's light steps.
        VoxelLight light;
        if (reads(output).voxels) {
            const bool indirect = reads(output).indirectLight;
            light = voxels().update({.scene = scene_,
                                     .light = direct,
                                     .surface = surface,
                                     .now = now,
                                     .output = output,
                                     .lightSteps = indirect && indirectTookSteps ? 0 : lightSteps,
                                     .allBounces = request.allBounces,
                                     .forceRebuild = settings_.revoxelize},
                                    timer_);
            indirectTookSteps |= indirect;
        }

        // The light of every pixel, or the part of it that the output shows (thesis 4.6).
        if (i == shades_.size()) shades_.emplace_back(shaders_, lightFeatures(), settings_);
        timer_.time(Step::trace, [&] { shades_[i].draw(output, surface, direct, light); });
    }

    timer_.endFrame();
    gl::checkErrors(std::string("frame, ") + outputName(request.outputs.front()));
    lastFrameFailed_ = false;
}

}  // namespace vct
