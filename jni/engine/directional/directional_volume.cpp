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

// A bit for each cascade that is not where it was.
std::uint32_t movedCascades(const std::optional<Cascades>& before, const Cascades& now) {
    if (!before) return DirectionalVoxels::allCascades;
    std::uint32_t moved = 0;
    for (int i = 0; i < now.count(); ++i)
        moved |= before->corner(i) != now.corner(i) ? 1U << i : 0U;
    return moved;
}

}  // namespace

DirectionalVolume::DirectionalVolume(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                                     const Settings& settings, const LightFeatures& sources)
    : shaders_(shaders),
      settings_(settings),
      sources_(sources),
      hasCascades_(settings.cascades > 1),
      voxelizesAll_(settings.revoxelize && !hasCascades_),
      hasDynamic_(scene.moves() || voxelizesAll_),
      voxels_(shaders, settings.grid, settings.cascades, settings.activeVoxelLimit, hasDynamic_,
              sources.emission),
      voxelizer_(shaders, scene, settings.grid, settings.cascades, sources.emission),
      counts_("counts of listed faces", sizeof(shared::CommandLists)),
      injector_(shaders, sources) {}

// Allocates all buffers before the frame, so that no frame waits for the GPU.
void DirectionalVolume::prepare(const GpuScene& scene, const Cascades& cascades) {
    shared::CommandLists found;
    if (isPrepared_) {
        // These are the counts of an earlier frame. If a list overflowed, this frame voxelizes again.
        if (!counts_.finish(&found, voxels_.index().commands())) return;
        growIfNeeded(found);
        if (light_) light_->onRaysBlocked(found.mostBlockedRays);
        return;
    }
    voxelizeStatic(scene, cascades);
    bool grew = hasDynamic_ || hasCascades_;
    while (grew) {
        voxelize(scene, cascades, hasCascades_ ? DirectionalVoxels::allCascades : 0);
        grew = growIfNeeded(voxels_.index().readCommands());
    }
    isPrepared_ = true;
}

// Lists the faces twice: the first pass counts them, the second has room for them.
void DirectionalVolume::voxelizeStatic(const GpuScene& scene, const Cascades& cascades) {
    voxels_.reset({});
    cascades_.reset();
    if (voxelizesAll_ || hasCascades_) return;
    voxelizer_.listFaces(scene, ScenePart::staticOnly, 0, voxels_, cascades);
    const shared::CommandLists found = voxels_.index().readCommands();
    voxels_.index().activeCounts(found);  // throws if the active-voxel list overflowed
    FaceCapacities capacities{};
    for (const std::size_t list : {0U, unsigned{VCT_BRICK_LEVEL}})
        capacities[list] = found.lists[list].faceCount;
    voxels_.reset(capacities);
    voxelizer_.listFaces(scene, ScenePart::staticOnly, 0, voxels_, cascades);
    voxelizer_.accumulate(scene, ScenePart::staticOnly, 0, voxels_, cascades);
    voxels_.markStatic();
    voxels_.resolve();
    if (!hasDynamic_) voxels_.dropSums();
}

void DirectionalVolume::voxelize(const GpuScene& scene, const Cascades& cascades, std::uint32_t moved) {
    if (moved != 0) {
        voxels_.beginStatic();
        const std::uint32_t list = voxels_.staticList();
        voxelizer_.listFaces(scene, ScenePart::staticOnly, list, voxels_, cascades, moved);
        voxelizer_.accumulate(scene, ScenePart::staticOnly, list, voxels_, cascades, moved);
        voxels_.endStatic();
    } else {
        voxels_.beginPose();
    }
    if (hasDynamic_) {
        const ScenePart part = voxelizesAll_ ? ScenePart::all : ScenePart::dynamicOnly;
        voxelizer_.listFaces(scene, part, voxels_.dynamicList(), voxels_, cascades);
        voxelizer_.accumulate(scene, part, voxels_.dynamicList(), voxels_, cascades);
    }
    voxels_.resolve();
}

bool DirectionalVolume::growIfNeeded(const shared::CommandLists& found) {
    FaceCapacities capacities = voxels_.capacities();
    const shared::LevelCommands& dynamic = found.lists[found.dynamicList];
    const shared::LevelCommands& still = found.lists[found.staticList];
    bool grows = dynamic.faceCount > capacities[VCT_LIST_DYNAMIC];
    if (hasCascades_) grows |= still.faceCount > capacities[VCT_LIST_STATIC];
    const shared::LevelCommands& blocks = found.lists[VCT_BRICK_LEVEL];
    grows |= blocks.faceCount > capacities[VCT_BRICK_LEVEL];
    if (grows) {
        const auto reserve = [&](std::size_t list, std::uint32_t staticCount, std::uint32_t count) {
            capacities[list] = std::max(capacities[list], staticCount + capacityFor(count));
        };
        for (const std::size_t pose : {0U, 1U}) {
            if (hasDynamic_) reserve(VCT_LIST_DYNAMIC + pose, 0, dynamic.faceCount);
            if (hasCascades_) reserve(VCT_LIST_STATIC + pose, 0, still.faceCount);
        }
        const std::uint32_t fixed = hasCascades_ ? 0 : blocks.staticFaces;
        reserve(VCT_BRICK_LEVEL, fixed, blocks.faceCount - fixed);
        voxels_.grow(capacities);
        // All is voxelized again. With cascades, faces that were there keep their light.
        if (hasCascades_)
            cascades_.reset();
        else
            cachedFor_.reset();
    }
    const auto overflows = [](const shared::LevelCommands& list) { return list.voxelCount > list.capacity; };
    if (overflows(dynamic) || (hasCascades_ && overflows(still))) {
        const shared::LevelCommands& list = overflows(dynamic) ? dynamic : still;
        throw Error((overflows(dynamic) ? "dynamic objects occupy " : "static objects occupy ") +
                    std::to_string(list.voxelCount) + " voxels at " + std::to_string(voxels_.grid()) +
                    "^3, but their list has a capacity of " + std::to_string(list.capacity) +
                    "; raise the limit of active voxels, or use a coarser grid");
    }
    return grows;
}

VoxelLight DirectionalVolume::update(const Inputs& inputs, StepTimer& timer) {
    const std::optional<SceneState> before = std::exchange(cachedFor_, {});
    const bool sameObjects = before && before->placements == inputs.now.placements;
    std::uint32_t moved = 0;
    if (hasCascades_)
        moved =
            inputs.forceRebuild ? DirectionalVoxels::allCascades : movedCascades(cascades_, inputs.cascades);
    bool isMoved = hasCascades_ && cascades_ != inputs.cascades;
    cascades_ = inputs.cascades;
    const bool voxelizes = moved != 0 || (hasDynamic_ && (inputs.forceRebuild || !sameObjects));
    if (voxelizes)
        timer.time(Step::voxelize, [&] {
            voxelize(inputs.scene, inputs.cascades, moved);
            // A picture of converged light waits for the GPU, so that its lists have room in it already.
            if (inputs.lightSteps > 1 && growIfNeeded(voxels_.index().readCommands())) {
                isMoved = hasCascades_;
                moved = hasCascades_ ? DirectionalVoxels::allCascades : 0;
                voxelize(inputs.scene, inputs.cascades, moved);
                cascades_ = inputs.cascades;
            }
            counts_.start(voxels_.index().commands());
        });
    if (light_ && (voxelizes || inputs.forceRebuild || before != inputs.now))
        light_->onVoxelsChanged({voxelizes, moved, before != inputs.now,
                                 !sameObjects || before->lightChanges != inputs.now.lightChanges,
                                 before && before->skyChanges != inputs.now.skyChanges, isMoved});
    cachedFor_ = inputs.now;

    VoxelLight light;
    light.directional = &voxels_;
    if (!reads(inputs.output).gathered()) return light;
    if (!light_) {
        GatherSettings gather = settings_.gather;
        // Hits are kept for a few frames only, if all surfaces are rebuilt in each.
        if (voxelizesAll_) gather.directions = std::min(gather.directions, 16);
        light_.emplace(shaders_, Irradiance::fitting(gather, voxels_.idCapacity()), settings_.lightFrames,
                       inputs.scene.moves() && !voxelizesAll_, hasDynamic_ || hasCascades_, sources_);
        if (inputs.baked && inputs.allBounces) light_->useBaked(inputs.baked, inputs.isBakedCurrent);
    }
    if (std::exchange(allBounces_, inputs.allBounces) != inputs.allBounces) light_->invalidate();
    const std::vector<glm::vec4> objects =
        voxelizesAll_ ? std::vector<glm::vec4>() : inputs.scene.movingSpheres(VCT_MAX_OBJECTS);
    for (int i = 0; i < inputs.lightSteps && !light_->isConverged(); ++i) {
        timer.time(Step::irradiance, [&] { light_->beginStep(voxels_, objects, inputs.allBounces); });
        if (light_->isDirectOutdated())
            timer.time(Step::inject, [&] { injector_.run(voxels_, inputs.light, *light_); });
        if (light_->isGatherNeeded()) timer.time(Step::irradiance, [&] { light_->gather(voxels_); });
        // A picture of converged light waits for the GPU, so that no ray is left out.
        if (i == 0 && inputs.lightSteps > 1 && !objects.empty())
            light_->onRaysBlocked(voxels_.index().readCommands().mostBlockedRays);
        if (inputs.onLightStep) inputs.onLightStep(i + 1, i + 1 + light_->stepsLeft());
    }
    if (const bool visibility = reads(inputs.output).ambientVisibility; light_->isOutdated(visibility))
        timer.time(Step::irradiance, [&] { light_->fillBricks(voxels_, visibility); });
    light.irradiance = light_->irradiance();
    light.bricks = light_->bricks();
    light.walls = light_->walls();
    return light;
}

Resources DirectionalVolume::resources() const {
    Resources resources = voxels_.resources();
    if (light_) {
        add(resources, light_->faceIrradiance());
        for (const gl::Texture* texture : light_->textures())
            add(resources, *texture);
    }
    return resources;
}

}  // namespace vct
