// The lit voxels of a scene, of either kind: packed ones, which are the thesis's, or directional ones.
#pragma once

#include "engine/gpu_scene.h"
#include "engine/passes/punctual_lights.h"
#include "engine/picture.h"
#include "engine/resource.h"
#include "engine/scene_state.h"
#include "engine/step_timer.h"
#include "engine/voxel_pyramid.h"

namespace vct {

// What the last pass reads of a volume. A texture that a picture does not need is null.
struct VoxelLight {
    const gl::Texture* packed = nullptr;      // the thesis's voxels, for its cones
    const gl::Texture* irradiance = nullptr;  // what surfaces receive: shaders/directional/irradiance.glsl
    const gl::Texture* bricks = nullptr;      // where in `irradiance` a block's texels lie
    const gl::Texture* faces = nullptr;       // the directional voxels, for cones of glossy surfaces
};

class VoxelVolume {
  public:
    virtual ~VoxelVolume() = default;

    struct Inputs {
        const GpuScene& scene;
        DirectLight light;
        SceneState now;
        Picture picture;  // decides which light is needed
        int lightSteps;   // that the received light may come nearer to its final value
        bool allBounces;  // or the first one alone
        bool remake;      // make the voxels anew where nothing has changed, too
    };
    // Brings the voxels, and of their light what the picture shows, up to date. Where nothing has changed
    // since the last call, nothing is computed.
    virtual VoxelLight update(const Inputs& inputs, StepTimer& timer) = 0;
    // What there is may be wrong, as a frame failed: the next update makes everything anew.
    virtual void forget() = 0;

    // Which voxels of each level are occupied.
    virtual const VoxelPyramid& occupancy() const = 0;
    virtual Resources resources() const = 0;
};

}  // namespace vct
