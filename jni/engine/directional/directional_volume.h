// Directional voxels and the irradiance of their faces, which pixels look up. Static geometry is voxelized
// once, dynamic objects in each pose. When a cascade moves, the static geometry that it reaches is voxelized.
// Light is injected into both when a light or a dynamic object changes.
#pragma once

#include <optional>

#include "engine/directional/directional_voxelizer.h"
#include "engine/directional/irradiance.h"
#include "engine/directional/light_injector.h"
#include "engine/voxel_volume.h"
#include "gl/async_read.h"

namespace vct {

class DirectionalVolume final : public VoxelVolume {
  public:
    DirectionalVolume(const gl::ShaderLibrary& shaders, const GpuScene& scene, const Settings& settings,
                      int pixelSamples, const LightFeatures& sources);

    void prepare(const GpuScene& scene, const Cascades& cascades) override;
    VoxelLight update(const Inputs& inputs, StepTimer& timer) override;
    void invalidate() override {
        cachedFor_.reset();
        isPrepared_ = false;
    }
    void dropUnread(Output output) override {
        if (!reads(output).gathered()) light_.reset();
    }

    const VoxelPyramid& occupancy() const override { return voxels_.index(); }
    Resources resources() const override;

    const DirectionalVoxels& voxels() const { return voxels_; }
    // Null if no output has needed it yet.
    const Irradiance* irradiance() const { return light_ ? &*light_ : nullptr; }

  private:
    void voxelizeDynamic(const GpuScene& scene, const Cascades& cascades);
    // Voxelizes the dynamic objects, and the static geometry of a region.
    void voxelize(const GpuScene& scene, const DirectionalVoxelizer::Region& still);
    // Removes what has moved and voxelizes it where it is now: dynamic objects, and the static geometry that
    // cascades have reached since the last call, or all of it. Returns a bit for each cascade whose static
    // geometry has changed.
    std::uint32_t revoxelize(const GpuScene& scene, const Cascades& cascades, bool rebuilds);
    // The capacities that the lists need; the present ones if all faces fit. Throws vct::Error if a list of
    // voxels overflowed, because its capacity is fixed.
    FaceCapacities capacitiesFor(const shared::CommandLists& found) const;
    // The same for the pages of blocks.
    std::uint32_t pagesFor(const shared::CommandLists& found) const;
    // If faces did not fit into their lists, grows these, and returns true: what changes has to be voxelized
    // again, in all cascades.
    bool growIfNeeded(const shared::CommandLists& found);

    gl::ShaderLibrary shaders_;
    Settings settings_;
    LightFeatures sources_;
    bool hasCascades_;   // more than one
    bool voxelizesAll_;  // Settings::revoxelize: everything is voxelized in each pose, as dynamic objects are
    bool hasDynamic_;    // a part of the scene is voxelized in each pose
    DirectionalVoxels voxels_;
    DirectionalVoxelizer voxelizer_;
    gl::AsyncRead counts_;  // list counts after the last voxelization of dynamic objects
    LightInjector injector_;
    std::optional<Irradiance> light_;   // created when an output needs it
    std::optional<Cascades> cascades_;  // their places in the last voxelization
    bool isPrepared_ = false;
    bool isIncomplete_ = false;            // static faces did not fit into the lists before they grew
    bool allBounces_ = true;               // light_ has all bounces
    std::optional<SceneState> cachedFor_;  // the state that the voxels were made for, if they are valid
};

}  // namespace vct
