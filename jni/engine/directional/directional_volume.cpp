#include "engine/directional/directional_volume.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/error.h"

namespace vct {

namespace {

// Capacity for a count that changes: half as many again, so that buffers rarely grow.
std::uint32_t capacityFor(std::uint32_t count) {
    return count + count / 2 + 256;
}

}  // namespace

DirectionalVolume::DirectionalVolume(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                                     const Settings& settings, const LightFeatures& sources)
    : shaders_(shaders),
      settings_(settings),
      sources_(sources),
      voxelizesAll_(settings.revoxelize || settings.cascades > 1),
      hasDynamic_(scene.moves() || voxelizesAll_),
      voxels_(shaders, settings.grid, settings.cascades, settings.activeVoxelLimit, hasDynamic_,
              sources.emission),
      voxelizer_(shaders, scene, settings.grid, sources.emission),
      counts_("counts of dynamic faces", sizeof(shared::CommandLists)),
      injector_(shaders, sources),
      mipmapper_(shaders),
      cascades_(settings.cascades, settings.grid) {}

// Allocates all buffers before the frame, so that no frame waits for the GPU.
void DirectionalVolume::prepare(const GpuScene& scene) {
    shared::CommandLists found;
    if (isPrepared_) {
        // These are the counts of an earlier frame. If a list overflowed, this frame voxelizes again.
        if (counts_.finish(&found) && growIfNeeded(found)) cachedFor_.reset();
        return;
    }
    voxelizeStatic(scene);
    bool grew = hasDynamic_;
    while (grew) {
        voxelizeDynamic(scene);
        grew = growIfNeeded(voxels_.index().readCommands());
    }
    isPrepared_ = true;
}

// Lists the faces twice: the first pass counts them, the second has room for them.
void DirectionalVolume::voxelizeStatic(const GpuScene& scene) {
    voxels_.reset({});
    if (voxelizesAll_) return;
    voxelizer_.listFaces(scene, ScenePart::staticOnly, 0, voxels_);
    const shared::CommandLists found = voxels_.index().readCommands();
    voxels_.index().activeCounts(found);  // throws if the active-voxel list overflowed
    FaceCapacities capacities{};
    for (int list = 0; list < voxels_.levels(); ++list)
        capacities[static_cast<std::size_t>(list)] = found.lists[list].faceCount;
    voxels_.reset(capacities);
    voxelizer_.listFaces(scene, ScenePart::staticOnly, 0, voxels_);
    voxelizer_.accumulate(scene, ScenePart::staticOnly, 0, voxels_);
    voxels_.markStatic();
}

void DirectionalVolume::voxelizeDynamic(const GpuScene& scene) {
    voxels_.beginPose();
    const ScenePart part = voxelizesAll_ ? ScenePart::all : ScenePart::dynamicOnly;
    voxelizer_.listFaces(scene, part, voxels_.dynamicList(), voxels_);
    voxelizer_.accumulate(scene, part, voxels_.dynamicList(), voxels_);
    counts_.start(voxels_.index().commands());
}

bool DirectionalVolume::growIfNeeded(const shared::CommandLists& found) {
    FaceCapacities capacities = voxels_.capacities();
    const shared::LevelCommands& dynamic = found.lists[found.dynamicList];
    bool grows = dynamic.faceCount > capacities[VCT_LIST_DYNAMIC];
    for (int level = 1; level < voxels_.levels(); ++level)
        grows |= found.lists[level].faceCount > capacities[static_cast<std::size_t>(level)];
    if (grows) {
        const auto reserve = [&](std::size_t list, std::uint32_t staticCount, std::uint32_t count) {
            capacities[list] = std::max(capacities[list], staticCount + capacityFor(count));
        };
        reserve(VCT_LIST_DYNAMIC, 0, dynamic.faceCount);
        reserve(VCT_LIST_DYNAMIC + 1, 0, dynamic.faceCount);
        for (int level = 1; level < voxels_.levels(); ++level) {
            const shared::LevelCommands& above = found.lists[level];
            reserve(static_cast<std::size_t>(level), above.staticFaces, above.faceCount - above.staticFaces);
        }
    }
    if (grows || dynamic.voxelCount > dynamic.capacity) voxels_.growDynamic(capacities);
    if (dynamic.voxelCount > dynamic.capacity) {
        cachedFor_.reset();
        throw Error("dynamic objects occupy " + std::to_string(dynamic.voxelCount) + " voxels at " +
                    std::to_string(voxels_.grid()) + "^3, but their list has a capacity of " +
                    std::to_string(dynamic.capacity) +
                    "; raise the limit of active voxels, or use a coarser grid");
    }
    return grows;
}

VoxelLight DirectionalVolume::update(const Inputs& inputs, StepTimer& timer) {
    const std::optional<SceneState> before = std::exchange(cachedFor_, {});
    const bool sameObjects = before && before->placements == inputs.now.placements;
    const bool moved = !(cascades_ == inputs.cascades);
    cascades_ = inputs.cascades;
    const bool voxelizes = hasDynamic_ && (inputs.forceRebuild || !sameObjects || moved);
    if (voxelizes) timer.time(Step::voxelize, [&] { voxelizeDynamic(inputs.scene); });
    if (voxelizes || inputs.forceRebuild || before != inputs.now) {
        isInjected_ = false;
        for (std::optional<Irradiance>* irradiance : {&light_, &occlusion_})
            if (*irradiance) (*irradiance)->onVoxelsChanged({voxelizes, before != inputs.now, moved});
    }
    cachedFor_ = inputs.now;

    const auto inject = [&](const Irradiance* irradiance) {
        const std::uint32_t frameIndex = irradiance != nullptr ? irradiance->frameIndex() : 0;
        timer.time(Step::inject, [&] { injector_.run(voxels_, inputs.light, irradiance, frameIndex); });
        timer.time(Step::mipmap, [&] { mipmapper_.run(voxels_, frameIndex); });
        isInjected_ = true;
    };
    VoxelLight light;
    light.faces = &voxels_.faces();
    light.faceRange = &voxels_.range();
    const bool occlusion = reads(inputs.output).ambientVisibility;
    if (!occlusion && !reads(inputs.output).indirectLight) {
        if (!isInjected_) inject(nullptr);
        return light;
    }
    Irradiance& irradiance = irradianceFor(occlusion ? GatherPurpose::occlusion : GatherPurpose::light);
    if (!occlusion && std::exchange(allBounces_, inputs.allBounces) != inputs.allBounces)
        irradiance.invalidate();
    if (occlusion && !isInjected_) inject(nullptr);
    for (int i = 0; i < inputs.lightSteps && !irradiance.isConverged(); ++i) {
        timer.time(Step::irradiance, [&] { irradiance.beginStep(voxels_, inputs.allBounces); });
        if (!occlusion) inject(&irradiance);
        timer.time(Step::irradiance, [&] { irradiance.gather(voxels_, inputs.surface); });
    }
    light.irradiance = irradiance.irradiance();
    light.bricks = irradiance.bricks();
    light.walls = irradiance.walls();
    return light;
}

Irradiance& DirectionalVolume::irradianceFor(GatherPurpose of) {
    std::optional<Irradiance>& pass = of == GatherPurpose::occlusion ? occlusion_ : light_;
    if (!pass)
        pass.emplace(shaders_, of == GatherPurpose::occlusion ? settings_.occlusion : settings_.gather, of,
                     settings_.lightFrames, hasDynamic_, featuresFor(of, sources_));
    return *pass;
}

const Irradiance* DirectionalVolume::irradiance(GatherPurpose of) const {
    const std::optional<Irradiance>& pass = of == GatherPurpose::occlusion ? occlusion_ : light_;
    return pass ? &*pass : nullptr;
}

Resources DirectionalVolume::resources() const {
    Resources resources = voxels_.resources();
    for (const std::optional<Irradiance>* pass : {&light_, &occlusion_}) {
        if (!*pass) continue;
        add(resources, (*pass)->faceIrradiance());
        for (const gl::Texture* texture : (*pass)->textures())
            add(resources, *texture);
    }
    return resources;
}

}  // namespace vct
