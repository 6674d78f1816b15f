// The frame. Depth as the sun sees it, surfaces as the camera sees them, the scene as voxels with their
// light, and what of all that reaches each pixel. What has not changed since the last frame is not made
// again.
#include <utility>

#include "engine/renderer.h"
#include "gl/debug.h"

namespace vct {

void Renderer::frame(Mode mode, const Camera& camera) {
    draw({static_cast<Picture>(mode)}, camera, {1, true});
}

void Renderer::renderConverged(Mode mode, const Camera& camera) {
    draw({static_cast<Picture>(mode)}, camera, {settings_.lightFrames, true});
}

void Renderer::renderPart(Picture view, const Camera& camera, bool allBounces) {
    draw({view}, camera, {settings_.lightFrames, allBounces});
}

void Renderer::frame(const std::vector<Picture>& pictures, const Camera& camera,
                     const GBuffer::Targets* surface, bool converged) {
    draw(pictures, camera, {converged ? settings_.lightFrames : 1, true}, surface);
}

void Renderer::draw(const std::vector<Picture>& pictures, const Camera& camera, LightSteps steps,
                    const GBuffer::Targets* given) {
    timer_.beginFrame();
    if (std::exchange(unfinished_, true)) forgetWhatWasMade();

    // Where everything is. Sorting the triangles of what moves by their axis takes the longest of it.
    if (nextPose_) timer_.timeOnCpu(Step::voxelize, [&] { scene_.setPose(*nextPose_); });
    nextPose_.reset();
    const SceneState now{scene_.placements(), light_.towardsLight};
    uploadFrameUniforms(camera);

    // Depth as the sun sees it (thesis 4.2): for direct light here, and for light in the voxels.
    const gl::Texture* shadow = nullptr;
    for (const Picture picture : pictures)
        if (readsShadowMap(picture))
            shadow = &shadowMap().update(scene_, now, picture, settings_.revoxelize, timer_);

    // Albedo, normal and depth of what the camera sees (thesis 4.3).
    const GBuffer::Targets surface =
        given != nullptr ? *given : timer_.time(Step::renderData, [&] { return gBuffer().draw(scene_); });

    bool lightIsUpToDate = false;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Picture picture = pictures[i];

        // Voxels, lit through the shadow map, their mip levels, and what surfaces receive of each other's
        // light (thesis 4.4 and 4.5; directional/irradiance.h).
        VoxelLight light;
        const bool showsTheSame = showsIndirectLight(picture) && std::exchange(lightIsUpToDate, true);
        if (readsVoxels(picture))
            light = voxels().update({scene_, *shadow, now, picture, showsTheSame ? 0 : steps.atMost,
                                     steps.allBounces, settings_.revoxelize},
                                    timer_);

        // Every pixel's direct and indirect light (thesis 4.6), or a part of it.
        if (i == shades_.size()) shades_.emplace_back(shaders_, settings_);
        timer_.time(Step::trace, [&] { shades_[i].draw(picture, surface, shadow, light); });
    }

    timer_.endFrame();
    gl::checkErrors("frame, mode or view " + std::to_string(pictures.front()));
    unfinished_ = false;
}

}  // namespace vct
