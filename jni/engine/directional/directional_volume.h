// Directional voxels, and the irradiance of their faces: a pixel only looks it up. Static geometry is
// voxelized once and dynamic objects in each pose; light is injected into both whenever it or they have
// changed.
#pragma once

#include <optional>

#include "engine/directional/directional_mipmapper.h"
#include "engine/directional/directional_voxelizer.h"
#include "engine/directional/irradiance.h"
#include "engine/directional/light_injector.h"
#include "engine/voxel_volume.h"
#include "gl/async_read.h"

namespace vct {

class DirectionalVolume final : public VoxelVolume {
  public:
    DirectionalVolume(const gl::ShaderLibrary& shaders, const GpuScene& scene, const Settings& settings,
                      const LightFeatures& sources);

    void prepare(const GpuScene& scene) override;
    VoxelLight update(const Inputs& inputs, StepTimer& timer) override;
    void invalidate() override {
        cachedFor_.reset();
        isPrepared_ = false;
    }

    const VoxelPyramid& occupancy() const override { return voxels_.index(); }
    Resources resources() const override;

    const DirectionalVoxels& voxels() const { return voxels_; }
    // Null until an output needed it.
    const Irradiance* irradiance(GatherPurpose of) const;

  private:
    void voxelizeStatic(const GpuScene& scene);
    void voxelizeDynamic(const GpuScene& scene);
    // Makes room where dynamic objects found none, and removes them then. Returns whether it did. Throws
    // vct::Error where their list of voxels is too short, which does not grow.
    bool growIfNeeded(const shared::CommandLists& found);
    Irradiance& irradianceFor(GatherPurpose of);

    gl::ShaderLibrary shaders_;
    Settings settings_;
    LightFeatures sources_;
    bool hasDynamic_;  // some of the scene is voxelized in each pose: all of it to measure that
    ScenePart dynamicPart_;
    DirectionalVoxels voxels_;
    DirectionalVoxelizer voxelizer_;
    gl::AsyncRead counts_;  // of the lists, after dynamic objects were voxelized
    LightInjector injector_;
    DirectionalMipmapper mipmapper_;
    std::optional<Irradiance> light_, occlusion_;  // since an output needed them
    bool isPrepared_ = false;
    bool isInjected_ = false;              // the faces have the present light
    bool allBounces_ = true;               // in the irradiance
    std::optional<SceneState> cachedFor_;  // what the voxels were made for; nothing where they were not
};

}  // namespace vct
