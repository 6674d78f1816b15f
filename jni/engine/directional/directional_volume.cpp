#include "engine/directional/directional_volume.h"

#include <algorithm>
#include <utility>

namespace vct {

DirectionalVolume::DirectionalVolume(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                                     const Settings& settings, const Volume& volume,
                                     const Bounds& boundsWorld, const LightFeatures& sources)
    : shaders_(shaders),
      settings_(settings),
      sources_(sources),
      shadowTexel_(glm::length(boundsWorld.max - boundsWorld.min) / settings.shadowMapSize / volume.side),
      voxels_(shaders, settings.grid, settings.activeVoxelLimit),
      voxelizer_(shaders, scene, settings.grid, Voxelization::sortedAxes),
      mipmapper_(shaders) {
    if (scene.moves()) incremental_.emplace(shaders, scene, Voxelization::sortedAxes);
}

VoxelLight DirectionalVolume::update(const Inputs& inputs, StepTimer& timer) {
    const std::optional<SceneState> before = std::exchange(made_, {});
    if (inputs.forceRebuild || before != inputs.now) makeVoxels(inputs, before, timer);
    made_ = inputs.now;

    VoxelLight light;
    light.faces = &voxels_.faces();
    const bool occlusion = reads(inputs.output).ambientVisibility;
    if (!occlusion && !reads(inputs.output).indirectLight) return light;
    Irradiance& received = irradiance(occlusion ? GatherOf::occlusion : GatherOf::light, inputs.scene);
    if (!occlusion && std::exchange(allBounces_, inputs.allBounces) != inputs.allBounces) received.forget();
    if (!received.settled())
        timer.time(Step::irradiance, [&] {
            for (int i = 0; i < inputs.lightSteps && !received.settled(); ++i)
                received.step(voxels_, mipmapper_, inputs.allBounces);
        });
    light.irradiance = received.irradiance();
    light.bricks = received.bricks();
    return light;
}

void DirectionalVolume::makeVoxels(const Inputs& inputs, const std::optional<SceneState>& before,
                                   StepTimer& timer) {
    Irradiance::Change change{std::nullopt, before != inputs.now};
    if (before && before->placements == inputs.now.placements && !inputs.forceRebuild) {
        if (!relighter_) relighter_.emplace(shaders_, inputs.scene, settings_.grid, Voxelization::sortedAxes);
        timer.time(Step::voxelize, [&] { relighter_->run(inputs.scene, inputs.light, voxels_); });
        timer.time(Step::mipmap, [&] { mipmapper_.update(voxels_, 0); });
    } else if (!incremental_) {
        timer.time(Step::voxelize, [&] { voxelizer_.run(inputs.scene, inputs.light, voxels_); });
        timer.time(Step::mipmap, [&] { mipmapper_.makeLevels(voxels_); });
        change.keptFaces = 0U;
    } else {
        for (bool hadRoom = false; !hadRoom;) {
            timer.time(Step::voxelize, [&] {
                const std::optional<BlockMask> dirty = dirtySince(before, inputs);
                incremental_->voxelize(inputs.scene, inputs.light, dirty ? &*dirty : nullptr, voxelizer_,
                                       mipmapper_, voxels_);
            });
            timer.time(Step::mipmap, [&] { hadRoom = incremental_->mipmap(voxels_); });
            change.keptFaces = std::min(change.keptFaces.value_or(VCT_NO_ENTRY), incremental_->keptFaces());
        }
    }
    for (std::optional<Irradiance>* received : {&light_, &occlusion_})
        if (*received) (*received)->note(change);
}

// Which blocks another pose can have changed; nothing where all can have changed.
std::optional<BlockMask> DirectionalVolume::dirtySince(const std::optional<SceneState>& before,
                                                       const Inputs& inputs) const {
    const SceneState& now = inputs.now;
    if (inputs.forceRebuild || !before || !before->sameLight(now)) return {};
    // The filter reads three texels to each side of a point at most, and compares them with the surface's
    // plane where they are, which may rise by 64 times as much (shaders/shared/shadow.glsl).
    const double above = 3.0 * 64.0 * shadowTexel_;
    const double voxel = 1.0 / settings_.grid;
    BlockMask dirty =
        dirtyBlocks(before->placements, now.placements,
                    {now.towardsLight, 4.0 * shadowTexel_, above, inputs.scene.staticBox()}, voxel);
    if (inputs.light.others == nullptr) return dirty;
    // Of more pairs of boxes and lights finding the blocks out takes longer than making all of them.
    constexpr int mostPairs = 16;
    int pairs = 0;
    for (std::size_t light = 0; light < now.lights.size(); ++light) {
        if (!now.lights[light].on) continue;
        const glm::dvec4 place = inputs.light.others->places()[light];
        for (std::size_t i = 0; i < now.placements.size(); ++i) {
            if (before->placements[i] == now.placements[i]) continue;
            if (place.w == 0.0 || ++pairs > mostPairs) return {};
            for (const Placement* placement : {&before->placements[i], &now.placements[i]})
                addShadow(dirty, grown(placement->box, snappingReach(voxel)),
                          {glm::dvec3(place), inputs.light.others->filterAngle()});
        }
    }
    return dirty;
}

Irradiance& DirectionalVolume::irradiance(GatherOf of, const GpuScene& scene) {
    std::optional<Irradiance>& pass = of == GatherOf::occlusion ? occlusion_ : light_;
    if (!pass)
        pass.emplace(shaders_, of == GatherOf::occlusion ? settings_.occlusion : settings_.gather, of,
                     settings_.lightFrames, scene.moves(), featuresFor(of, sources_));
    return *pass;
}

const Irradiance* DirectionalVolume::received(GatherOf of) const {
    const std::optional<Irradiance>& pass = of == GatherOf::occlusion ? occlusion_ : light_;
    return pass ? &*pass : nullptr;
}

Resources DirectionalVolume::resources() const {
    Resources resources = voxels_.resources();
    if (incremental_)
        for (const gl::Buffer* buffer : incremental_->buffers())
            add(resources, *buffer);
    for (const std::optional<Irradiance>* pass : {&light_, &occlusion_}) {
        if (!*pass) continue;
        add(resources, (*pass)->received());
        for (const gl::Texture* texture : (*pass)->textures())
            add(resources, *texture);
    }
    return resources;
}

}  // namespace vct
