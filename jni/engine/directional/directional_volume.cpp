#include "engine/directional/directional_volume.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "core/error.h"

namespace vct {

namespace {

// Capacities for counts that change, so that buffers rarely grow. Objects have room for as many faces again,
// because they may turn and come nearer (a box that turns by 20 degrees about one axis has twice as many
// faces as along the axes, one that turns about all of them 4.3 times).
std::uint32_t roomForObjects(std::uint32_t count) {
    return 2 * count + 256;
}
// One cascade moves at a time, and may reach three times as many new faces as lie in an eighth of it in the
// mean, before the ids of those that it has left are free. So many are left after a list has grown, and a
// list grows if fewer than sparesForMove() are.
std::uint32_t roomForMoves(std::uint32_t count, int cascades) {
    return count + 3 * count / (8 * static_cast<std::uint32_t>(std::max(cascades, 3))) + 256;
}
std::uint32_t sparesForMove(std::uint32_t capacity, int cascades) {
    return 3 * capacity / (10 * static_cast<std::uint32_t>(std::max(cascades, 3)));
}

// The moves of the cascades. Moves by more than a cascade's side leave nothing of it, as one by its side
// does.
CascadeShifts shiftsOf(const Cascades& before, const Cascades& now, int grid) {
    CascadeShifts shifts{};
    for (int i = 0; i < now.count(); ++i) {
        const glm::dvec3 voxels = (now.corner(i) - before.corner(i)) * (grid / now.side(i));
        shifts.at(static_cast<std::size_t>(i)) =
            glm::ivec3(glm::round(glm::clamp(voxels, -static_cast<double>(grid), static_cast<double>(grid))));
    }
    return shifts;
}

// True if a cascade has moved so far that it holds mostly new faces.
bool isFar(const CascadeShifts& shifts, int grid) {
    return std::any_of(shifts.begin(), shifts.end(), [=](const glm::ivec3& shift) {
        return std::max({std::abs(shift.x), std::abs(shift.y), std::abs(shift.z)}) > grid / 4;
    });
}

// A bit for each cascade that has moved.
std::uint32_t movedCascades(const CascadeShifts& shifts) {
    std::uint32_t moved = 0;
    for (std::size_t i = 0; i < shifts.size(); ++i)
        moved |= shifts.at(i) != glm::ivec3(0) ? 1U << i : 0U;
    return moved;
}

}  // namespace

DirectionalVolume::DirectionalVolume(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                                     const Settings& settings, int pixelSamples, const LightFeatures& sources)
    : shaders_(shaders),
      settings_(settings),
      sources_(sources),
      hasCascades_(settings.cascades > 1),
      voxelizesAll_(settings.revoxelize && !hasCascades_),
      hasDynamic_(scene.moves() || voxelizesAll_),
      voxels_(shaders, settings.grid, settings.cascades, settings.activeVoxelLimit, hasDynamic_,
              sources.emission),
      voxelizer_(shaders, scene, settings.grid, pixelSamples, sources.emission),
      counts_("counts of listed faces", sizeof(shared::CommandLists)),
      injector_(shaders, sources) {}

// Allocates all buffers before the frame. The first call voxelizes everything, and waits for the GPU; later
// ones do not.
void DirectionalVolume::prepare(const GpuScene& scene, const Cascades& cascades) {
    shared::CommandLists found;
    if (isPrepared_) {
        // These are the counts of an earlier frame. If a list overflowed, this frame voxelizes again.
        if (!counts_.finish(&found, voxels_.index().commands())) return;
        growIfNeeded(found);
        if (light_) {
            light_->onRaysBlocked(found.mostBlockedRays);
            light_->onBricksPlaced(found);
        }
        return;
    }
    // Everything is voxelized twice: first to count the faces, then into lists that have room for them.
    voxels_.reset({}, 0);
    for (;;) {
        voxelize(scene, {cascades});
        const shared::CommandLists listed = voxels_.index().readCommands();
        const FaceCapacities needed = capacitiesFor(listed);
        const std::uint32_t pages = pagesFor(listed);
        if (needed == voxels_.capacities() && pages == voxels_.pageCapacity()) break;
        voxels_.reset(needed, pages);
    }
    voxels_.shrinkSums();
    cascades_ = cascades;
    isIncomplete_ = false;
    if (light_) light_->invalidate();
    isPrepared_ = true;
}

void DirectionalVolume::voxelize(const GpuScene& scene, const DirectionalVoxelizer::Region& still) {
    if (!voxelizesAll_) {
        voxelizer_.listFaces(scene, ScenePart::staticOnly, 0, voxels_, still);
        voxelizer_.accumulate(scene, ScenePart::staticOnly, 0, voxels_, still);
        voxels_.markStatic();
    }
    if (hasDynamic_) voxelizeDynamic(scene, still.cascades);
    voxels_.resolve(still.moved, scene.movingBounds());
}

void DirectionalVolume::voxelizeDynamic(const GpuScene& scene, const Cascades& cascades) {
    const ScenePart part = voxelizesAll_ ? ScenePart::all : ScenePart::dynamicOnly;
    voxelizer_.listFaces(scene, part, voxels_.dynamicList(), voxels_, {cascades});
    voxelizer_.accumulate(scene, part, voxels_.dynamicList(), voxels_, {cascades});
}

std::uint32_t DirectionalVolume::revoxelize(const GpuScene& scene, const Cascades& cascades, bool rebuilds) {
    const CascadeShifts shifts = shiftsOf(*cascades_, cascades, voxels_.grid());
    const std::uint32_t moved = movedCascades(shifts);
    rebuilds = hasCascades_ && (rebuilds || isIncomplete_);
    cascades_ = cascades;
    isIncomplete_ = false;
    if (moved == 0 && !rebuilds) {
        voxels_.beginPose();
        voxelizeDynamic(scene, cascades);
        voxels_.resolve(0, scene.movingBounds());
        return 0;
    }
    using StaticFaces = DirectionalVoxels::StaticFaces;
    const bool isLong = isFar(shifts, voxels_.grid());
    voxels_.beginMove(shifts, moved,
                      rebuilds ? StaticFaces::all
                      : isLong ? StaticFaces::ofLongMove
                               : StaticFaces::ofMove);
    if (rebuilds)
        voxelize(scene, {cascades});
    else
        voxelize(scene, {cascades, moved, &shifts});
    if (rebuilds || isLong) voxels_.shrinkSums();
    return rebuilds ? DirectionalVoxels::allCascades : moved;
}

FaceCapacities DirectionalVolume::capacitiesFor(const shared::CommandLists& found) const {
    FaceCapacities capacities = voxels_.capacities();
    const shared::LevelCommands& dynamic = found.lists[found.dynamicList];
    const shared::LevelCommands& still = found.lists[0];
    const shared::LevelCommands& blocks = found.lists[VCT_BRICK_LEVEL];
    if (still.staticVoxels > still.capacity)
        throw Error("static objects occupy " + std::to_string(still.staticVoxels) + " voxels at " +
                    std::to_string(voxels_.grid()) + "^3, but their list has a capacity of " +
                    std::to_string(still.capacity) +
                    "; raise the limit of active voxels, or use a coarser grid");
    // The static faces of one cube never change. Those of cascades get room before they need it, because rays
    // miss a face without room.
    const std::uint32_t listed = std::min(still.faceCount, still.faceCapacity),
                        unused = still.faceCapacity - listed + found.unusedIds -
                                 std::min(found.takenIds, found.unusedIds);
    const bool runsOut = hasCascades_ && unused < sparesForMove(still.faceCapacity, settings_.cascades);
    if (found.unplacedFaces > 0 || runsOut) {
        const std::uint32_t needed = still.faceCapacity + found.unplacedFaces;
        capacities[0] =
            std::max(capacities[0], hasCascades_ ? roomForMoves(needed, settings_.cascades) : needed);
    }
    if (dynamic.faceCount > capacities[VCT_LIST_DYNAMIC])
        capacities[VCT_LIST_DYNAMIC] = capacities[VCT_LIST_DYNAMIC + 1] = roomForObjects(dynamic.faceCount);
    if (blocks.faceCount + (hasCascades_ ? blocks.faceCount / 32 : 0) > capacities[VCT_BRICK_LEVEL]) {
        const std::uint32_t ofStatic = blocks.staticFaces;
        capacities[VCT_BRICK_LEVEL] = (hasCascades_ ? roomForMoves(ofStatic, settings_.cascades) : ofStatic) +
                                      (hasDynamic_ ? roomForObjects(blocks.faceCount - ofStatic) : 0);
    }
    return capacities;
}

std::uint32_t DirectionalVolume::pagesFor(const shared::CommandLists& found) const {
    if (!hasCascades_) return 0;
    const std::uint32_t wanted = found.pageCapacity - found.freePages + found.takenPages;
    const bool runsOut = wanted + found.pageCapacity / 32 > found.pageCapacity;
    return std::max(voxels_.pageCapacity(), runsOut ? wanted + wanted / 16 + 64 : 0);
}

bool DirectionalVolume::growIfNeeded(const shared::CommandLists& found) {
    const FaceCapacities capacities = capacitiesFor(found);
    const std::uint32_t pages = pagesFor(found);
    const bool isSame = capacities == voxels_.capacities() && pages == voxels_.pageCapacity();
    // The next move may bring twice as many faces.
    const bool missSums = found.takenSums > found.staticSums;
    if (2 * found.takenSums > found.staticSums) voxels_.reserveSums(2 * found.takenSums);
    if (isSame && !missSums) return false;
    // If something did not fit, all is voxelized again. Faces that were there keep their light.
    isIncomplete_ |= found.unplacedFaces > 0 || found.takenPages > found.freePages || missSums ||
                     found.lists[VCT_BRICK_LEVEL].faceCount > voxels_.capacities()[VCT_BRICK_LEVEL];
    if (!isSame) voxels_.grow(capacities, pages);
    if (isIncomplete_ || hasDynamic_) cachedFor_.reset();
    return true;
}

VoxelLight DirectionalVolume::update(const Inputs& inputs, StepTimer& timer) {
    const std::optional<SceneState> before = std::exchange(cachedFor_, {});
    const bool sameObjects = before && before->placements == inputs.now.placements;
    std::uint32_t moved = 0;
    const bool isMoved = !(*cascades_ == inputs.cascades);
    const CascadeShifts shifts = shiftsOf(*cascades_, inputs.cascades, voxels_.grid());
    const bool isJump = isFar(shifts, voxels_.grid());
    const bool changesStatic = isMoved || (hasCascades_ && (inputs.forceRebuild || isIncomplete_));
    const bool posesObjects = hasDynamic_ && (inputs.forceRebuild || !sameObjects);
    const bool voxelizes = changesStatic || posesObjects;
    Bounds changed = noBounds;
    if (voxelizes)
        timer.time(Step::voxelize, [&] {
            moved = revoxelize(inputs.scene, inputs.cascades, inputs.forceRebuild);
            changed = voxels_.changed();
            // A picture of converged light waits for the GPU, so that its lists have room in it already.
            if (inputs.lightSteps > 1 && growIfNeeded(voxels_.index().readCommands()) &&
                (isIncomplete_ || hasDynamic_)) {
                moved |= revoxelize(inputs.scene, inputs.cascades, false);
                changed = united(changed, voxels_.changed());
            }
            counts_.start(voxels_.index().commands());
        });
    if (light_ && (voxelizes || inputs.forceRebuild || before != inputs.now))
        light_->onVoxelsChanged({.lists = voxelizes,
                                 .voxelized = moved,
                                 .light = before != inputs.now,
                                 .emitters = !sameObjects || before->lightChanges != inputs.now.lightChanges,
                                 .sky = before && before->skyChanges != inputs.now.skyChanges,
                                 .all = isJump || posesObjects,
                                 .cascades = isMoved},
                                shifts, changed);
    cachedFor_ = inputs.now;

    VoxelLight light;
    light.directional = &voxels_;
    if (!reads(inputs.output).gathered()) return light;
    if (light_ && !light_->hasBitsFor(voxels_.idCapacity())) light_.reset();
    if (!light_) {
        light_.emplace(shaders_, Irradiance::fitting(settings_.gatherOfFrames(), voxels_.idCapacity()),
                       settings_.lightFrames, inputs.scene.moves() && !voxelizesAll_,
                       hasDynamic_ || hasCascades_, settings_.cascades, sources_);
        if (inputs.baked && inputs.allBounces) light_->useBaked(inputs.baked, inputs.isBakedCurrent);
    }
    if (std::exchange(allBounces_, inputs.allBounces) != inputs.allBounces) light_->invalidate();
    const std::vector<glm::vec4> objects =
        voxelizesAll_ ? std::vector<glm::vec4>() : inputs.scene.movingSpheres(VCT_MAX_OBJECTS);
    for (int i = 0; i < inputs.lightSteps && !light_->isConverged(); ++i) {
        timer.time(Step::irradiance, [&] { light_->beginStep(voxels_, objects, inputs.allBounces); });
        if (light_->isDirectOutdated())
            timer.time(Step::inject, [&] { injector_.run(voxels_, inputs.light, *light_); });
        // A picture of converged light waits for the GPU, so that no ray and no brick is left out.
        const bool waits = i == 0 && inputs.lightSteps > 1;
        if (light_->isGatherNeeded()) timer.time(Step::irradiance, [&] { light_->gather(voxels_, waits); });
        if (waits && (hasDynamic_ || hasCascades_)) light_->onBricksPlaced(voxels_.index().readCommands());
        if (inputs.onLightStep) inputs.onLightStep(i + 1, i + 1 + light_->stepsLeft());
    }
    if (const bool visibility = reads(inputs.output).ambientVisibility; light_->isOutdated(visibility))
        timer.time(Step::irradiance, [&] { light_->fillBricks(voxels_, visibility); });
    light.bricks = light_->bricks();
    light.brickPlaces = light_->brickPlaces();
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
