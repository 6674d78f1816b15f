// The interface of a scene's lit voxels, packed (the thesis's) or directional.
#pragma once

#include <functional>
#include <memory>

#include "engine/cascades.h"
#include "engine/gpu_scene.h"
#include "engine/output.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/punctual_lights.h"
#include "engine/resource.h"
#include "engine/scene_state.h"
#include "engine/step_timer.h"
#include "engine/voxel_pyramid.h"

namespace vct {

class DirectionalVoxels;
struct BakedLight;

// The textures and buffers that the last pass reads. Those that an output does not need are null.
struct VoxelLight {
    const gl::Texture* packed = nullptr;             // packed voxels, for the thesis's cones
    const gl::Texture* bricks = nullptr;             // bricks of face irradiance
    const gl::Texture* brickPlaces = nullptr;        // the place of each block's brick in `bricks`
    const gl::Texture* walls = nullptr;              // thin walls across the bricks
    const DirectionalVoxels* directional = nullptr;  // for the rays of glossy surfaces
};

// Is told after each light step how many of the steps to convergence are done.
using OnLightStep = std::function<void(int done, int steps)>;

class VoxelVolume {
  public:
    virtual ~VoxelVolume() = default;

    struct Inputs {
        const GpuScene& scene;
        DirectLight light;
        SceneState now;
        const Cascades& cascades;                        // their places in this frame
        Output output;                                   // decides which light is needed
        int lightSteps;                                  // largest number of light steps to take
        bool allBounces;                                 // false: the first bounce only
        const std::shared_ptr<const BakedLight>& baked;  // null: none; see Irradiance::useBaked()
        bool isBakedCurrent;
        bool forceRebuild;               // rebuild the voxels even if nothing has changed
        const OnLightStep& onLightStep;  // may be empty
    };
    // Allocates the buffers that updates need, and waits for the GPU if their sizes are unknown. Call it
    // before the first pass of a frame.
    virtual void prepare(const GpuScene&, const Cascades&) {}
    // Brings the voxels, and the part of their light that the output shows, up to date. Computes nothing if
    // nothing has changed since the last call and the light has converged.
    virtual VoxelLight update(const Inputs& inputs, StepTimer& timer) = 0;
    // Marks everything as out of date. Call it after a frame that failed.
    virtual void invalidate() = 0;
    // Frees light that the output does not read.
    virtual void dropUnread(Output) {}

    // The occupied voxels of each level.
    virtual const VoxelPyramid& occupancy() const = 0;
    virtual Resources resources() const = 0;
};

}  // namespace vct
