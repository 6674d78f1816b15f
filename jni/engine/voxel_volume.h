// The lit voxels of a scene, of either kind: packed ones, which are the thesis's, or directional ones.
#pragma once

#include "engine/gpu_scene.h"
#include "engine/output.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/punctual_lights.h"
#include "engine/resource.h"
#include "engine/scene_state.h"
#include "engine/step_timer.h"
#include "engine/voxel_pyramid.h"

namespace vct {

// The textures and buffers of a volume that the last pass reads. One that an output does not need is null.
struct VoxelLight {
    const gl::Texture* packed = nullptr;      // the thesis's voxels, for its cones
    const gl::Texture* irradiance = nullptr;  // what surfaces receive: shaders/directional/irradiance.glsl
    const gl::Texture* bricks = nullptr;      // where in `irradiance` a block's texels lie
    const gl::Texture* faces = nullptr;       // the directional voxels, for cones of glossy surfaces
    const gl::Buffer* faceRange = nullptr;    // shared::FaceRange of `faces`
};

class VoxelVolume {
  public:
    virtual ~VoxelVolume() = default;

    struct Inputs {
        const GpuScene& scene;
        DirectLight light;
        const GBuffer::Targets& surface;  // what pixels show
        SceneState now;
        Output output;      // decides which light is needed
        int lightSteps;     // most that face irradiance may take towards its final value
        bool allBounces;    // or the first one alone
        bool forceRebuild;  // of the voxels, even where nothing has changed
    };
    // Makes what updates need room for, and waits for the GPU where that has to be found out. To be called
    // before the first pass of a frame.
    virtual void prepare(const GpuScene&) {}
    // Brings the voxels, and of their light what the picture shows, up to date. Where nothing has changed
    // since the last call, nothing is computed.
    virtual VoxelLight update(const Inputs& inputs, StepTimer& timer) = 0;
    // Marks everything as out of date, as a frame failed.
    virtual void invalidate() = 0;

    // Says which voxels of each level are occupied.
    virtual const VoxelPyramid& occupancy() const = 0;
    virtual Resources resources() const = 0;
};

}  // namespace vct
