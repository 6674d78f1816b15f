// Renders one frame in the order of C. Wahlén's thesis (docs/voxel-cone-tracing.md): shadow maps, G-buffer,
// lit voxels, and a last pass that computes the light of every pixel.
//
// The last pass runs in every frame. The G-buffer pass also does, unless the caller brings its own G-buffer.
// Shadow maps and voxels depend on the scene's state and, with cascades, on where these are, but not on the
// camera's view. Each is created when an output first needs it, stores the state that it was made for, and is
// rebuilt only when the state changes. Settings::revoxelize rebuilds them in every frame, so that their time
// can be measured.
//
// reads() (engine/output.h) says which of these inputs an output needs.
#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

#include "engine/frame_uniforms.h"
#include "engine/renderer.h"
#include "gl/debug.h"

namespace vct {

void Renderer::render(const RenderRequest& request) {
    timer_.beginFrame();
    // The flag stays set if a frame throws an exception, which may leave shadow maps and voxels incomplete.
    if (lastFrameFailed_) invalidateCaches();
    lastFrameFailed_ = true;

    // Apply the pose. It is timed as voxelization because re-sorting the moved triangles dominates.
    if (nextPose_) timer_.timeOnCpu(Step::voxelize, [&] { applyPose(*nextPose_); });
    nextPose_.reset();
    const SceneState now = state();
    const bool readsVoxels = std::any_of(request.outputs.begin(), request.outputs.end(),
                                         [](Output output) { return reads(output).voxels; });
    // Nested cubes of voxels, and tiles of the sun's shadow map around them, follow the camera, if the scene
    // has more than one.
    const bool keepsLight = request.lightSteps == LightSteps::none && hasLight();
    if (!keepsLight) cascades_.follow(eyeInVolume(request.camera, volume_));
    const shared::FrameUniforms uniforms = uploadFrameUniforms(request.camera, voxelizedCascades_);
    if (readsVoxels) {
        // The first call voxelizes the static geometry, outside of all timed steps. Later calls take the
        // counts of earlier frames, and grow buffers.
        voxels().prepare(scene_, cascades_);
        voxelizedCascades_ = cascades_;
    }

    // Shadow maps of the sun (thesis 4.2) and of the punctual lights. Pixels and voxels take their direct
    // light through them. The sun's map is drawn once for a state. For an output with a soft shadow, update()
    // also draws its coarser levels.
    DirectLight direct{{}, punctualLights_ ? &*punctualLights_ : nullptr};
    for (const Output output : request.outputs)
        if (reads(output).shadowMap())
            direct.sun =
                shadowMap().update(scene_, now, cascades_, uniforms, output, settings_.revoxelize, timer_);
    if (punctualLights_) punctualLights_->update(scene_, now, settings_.revoxelize, timer_);

    // The G-buffer: albedo, normal and depth of the visible surfaces (thesis 4.3, "render data").
    const GBuffer::Targets surface =
        request.surface != nullptr
            ? *request.surface
            : timer_.time(Step::renderData, [&] { return gBuffer().draw(scene_, uniforms.clipFromVolume); });

    const int lightSteps = request.lightSteps == LightSteps::all ? std::numeric_limits<int>::max()
                           : keepsLight                          ? 0
                                                                 : 1;
    bool tookSteps = false;
    // Bricks hold ambient visibility or light. Light comes last, because the look-up of embedding programs
    // reads it after the frame.
    std::vector<std::size_t> order(request.outputs.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t i) { return reads(request.outputs[i]).ambientVisibility; });
    for (const std::size_t i : order) {
        const Output output = request.outputs[i];

        // Lit voxels (thesis 4.4), and with the preset thesis their mip levels (4.5). Otherwise faces gather
        // indirect light and ambient visibility. A frame takes one light step (inject direct light, trace,
        // gather, smooth), or all steps until the light has converged. If several outputs show what faces
        // gather, the first one takes the steps, and the others reuse the result.
        VoxelLight light;
        if (reads(output).voxels) {
            light = voxels().update({.scene = scene_,
                                     .light = direct,
                                     .now = now,
                                     .cascades = cascades_,
                                     .output = output,
                                     .lightSteps = tookSteps ? 0 : lightSteps,
                                     .allBounces = request.allBounces,
                                     .baked = bakedLight_,
                                     .isBakedCurrent = !isLightChanged_,
                                     .forceRebuild = settings_.revoxelize,
                                     .onLightStep = request.onLightStep},
                                    timer_);
            tookSteps |= reads(output).gathered();
        }

        // The light of every pixel, or the part of the light that the output shows (thesis 4.6).
        while (i >= shades_.size())
            shades_.emplace_back(shaders_, lightFeatures(), settings_);
        timer_.time(Step::trace, [&] { shades_[i].draw(output, surface, direct, light); });
    }

    timer_.endFrame();
    gl::checkErrors(std::string("frame, ") + outputName(request.outputs.front()));
    lastFrameFailed_ = false;
}

void Renderer::prepareVoxels(const Camera& camera) {
    if (lastFrameFailed_) invalidateCaches();
    lastFrameFailed_ = true;
    cascades_.follow(eyeInVolume(camera, volume_));
    uploadFrameUniforms(camera, voxelizedCascades_);
    voxels().prepare(scene_, cascades_);
    voxelizedCascades_ = cascades_;
    lastFrameFailed_ = false;
}

}  // namespace vct
