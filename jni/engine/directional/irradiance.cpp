#include "engine/directional/irradiance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

float largestBounceShare(const Scene& scene) {
    float largest = 0.0F;
    for (const Instance& instance : scene.instances) {
        // A texture can only make the albedo smaller.
        const glm::vec4& color = scene.materials[scene.meshes[instance.mesh].material].baseColor;
        largest = std::max({largest, color.r, color.g, color.b});
    }
    return std::min(largest, 0.95F);
}

namespace {

// The size of a texture with one texel per face of each block.
glm::ivec3 blocksSize(const DirectionalVoxels& voxels) {
    return voxels.grid() / VCT_BRICK_SIDE *
           glm::ivec3(DirectionalVoxels::directionsX, DirectionalVoxels::directionsY, voxels.cascades());
}

// Dispatches one invocation per texel, in groups of 4^3.
void dispatchOver(const glm::ivec3& texels) {
    const glm::uvec3 groups = (texels + 3) / 4;
    gl::DispatchCompute(groups.x, groups.y, groups.z);
}

void append(std::vector<std::string>& defines, const std::vector<std::string>& more) {
    defines.insert(defines.end(), more.begin(), more.end());
}

}  // namespace

gl::ProgramDescription lightProgram(const std::string& name, const LightFeatures& sources) {
    std::vector<std::string> defines = lightDefines(sources);
    append(defines, emissionDefines(sources.emission));
    return {name, {"directional/" + name + ".comp"}, defines};
}

gl::ProgramDescription emittersProgram(const LightFeatures& sources) {
    return {"emitters", {"directional/emitters.comp"}, lightProgram("emitters", sources).defines};
}

gl::ProgramDescription gatherProgram(const GatherSettings& settings, const LightFeatures& sources) {
    std::vector<std::string> defines = gatherDefines(settings);
    defines.push_back("VCT_RECENT_STEP_WEIGHT " + number(recentStepWeight));
    append(defines, lightDefines(sources));
    append(defines, emissionDefines(sources.emission));
    return {"gather", {"directional/gather.comp"}, defines};
}

Irradiance::Irradiance(const gl::ShaderLibrary& shaders, const GatherSettings& settings, int lightFrames,
                       bool listsChange, const LightFeatures& sources)
    : settings_(settings),
      schedule_(settings, lightFrames),
      clearBricks_(shaders, lightProgram("clear_bricks", sources)),
      placeBricks_(shaders, lightProgram("place_bricks", sources)),
      markWalls_(shaders, lightProgram("mark_walls", sources)),
      markLookups_(shaders, lightProgram("mark_lookups", sources)),
      chooseFaces_(shaders, lightProgram("choose_faces", sources)),
      gather_(shaders, gatherProgram(settings, sources)),
      lightBlocks_(shaders, lightProgram("light_blocks", sources)),
      fillBricks_(shaders, lightProgram("fill_bricks", sources)),
      uniforms_("light step", GL_UNIFORM_BUFFER, sizeof(shared::LightStep), nullptr, GL_DYNAMIC_DRAW) {
    if (listsChange) carryOver_.emplace(shaders, lightProgram("carry_over", sources));
    if (sources.emitters) emitters_.emplace(shaders, emittersProgram(sources));
}

void Irradiance::onVoxelsChanged(const GatherSchedule::Change& change) {
    pending_.lists |= change.lists;
    pending_.voxelized |= change.voxelized;
    pending_.light |= change.light;
    pending_.cascades |= change.cascades;
    if (!change.lists) return;
    placesBricks_ = true;
    (change.cascades && !change.light ? newEmitterSteps_ : emitterSteps_) = VCT_TURN_PERIOD;
}

void Irradiance::invalidate() {
    placesBricks_ = marksAllWalls_ = true;
    emitterSteps_ = VCT_TURN_PERIOD;
    schedule_.invalidate();
}

void Irradiance::beginStep(const DirectionalVoxels& voxels, const GBuffer::Targets& surface,
                           bool allBounces) {
    const gl::DebugGroup group("begin light step");
    const GatherSchedule::Change change = std::exchange(pending_, {});
    const bool wasSmoothed = step_.smoothing > 0.0F;
    step_ = schedule_.advance(change);
    // While only cascades move, most faces do not gather, and their texels stay as they are.
    outdated_ =
        std::max(outdated_, visitsAll() || placesBricks_ || wasSmoothed ? Outdated::all : Outdated::active);
    reserveFaces(voxels);
    reserveBricks(voxels, voxels.capacities()[VCT_BRICK_LEVEL]);
    uploadUniforms(allBounces);
    // The last frame fetched textures that this step writes, and earlier passes wrote data that it reads.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    bind(voxels);
    if (std::exchange(placesBricks_, false)) {
        if (change.voxelized != 0) carryOver(voxels, voxels.staticList());
        if (carryOver_ && voxels.hasDynamicObjects()) carryOver(voxels, voxels.dynamicList());
        placeBricks(voxels, marksAllWalls_ ? DirectionalVoxels::allCascades : change.voxelized);
        marksAllWalls_ = false;
    }
    chooseFaces(voxels, surface);
}

void Irradiance::dispatchOverFaces(const DirectionalVoxels& voxels, bool all) const {
    if (all)
        voxels.index().dispatchOverFaces(0);
    else
        gl::DispatchCompute(static_cast<GLuint>((settings_.rayBudget + VCT_LIST_GROUP - 1) / VCT_LIST_GROUP),
                            1, 1);
}

void Irradiance::carryOver(const DirectionalVoxels& voxels, std::uint32_t list) const {
    carryOver_->use();
    gl::Uniform1ui(VCT_UNIFORM_LIST, list);
    voxels.staticIndex().bind(VCT_TEX_VOXELS);
    voxels.indexOf(list ^ 1U).bind(VCT_TEX_PREVIOUS_VOXELS);
    voxels.index().dispatchOverFaces(0);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void Irradiance::gather(const DirectionalVoxels& voxels) {
    const gl::DebugGroup group("gather");
    bind(voxels);
    voxels.bindForRays();
    if (emitters_ && std::max(emitterSteps_, newEmitterSteps_) > 0) {
        emitters_->use();
        const bool all = emitterSteps_ > 0 || visitsAll();
        gl::Uniform1ui(VCT_UNIFORM_ALL, all ? 1 : 0);
        emitterSteps_ = std::max(emitterSteps_ - 1, 0);
        newEmitterSteps_ = std::max(newEmitterSteps_ - 1, 0);
        dispatchOverFaces(voxels, all);
        gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    gather_.use();
    dispatchOverFaces(voxels, step_.rayBudget == 0);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    lightBlocks_.use();
    blockLight_->bindImage(VCT_IMAGE_BLOCK_LIGHT, 0, GL_WRITE_ONLY);
    dispatchOver(blocksSize(voxels));
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void Irradiance::fillBricks(const DirectionalVoxels& voxels, bool visibility) {
    if (std::exchange(showsVisibility_, visibility) != visibility) outdated_ = Outdated::all;
    const Outdated outdated = std::exchange(outdated_, Outdated::none);
    const gl::DebugGroup group("fill bricks");
    bind(voxels);
    fillBricks_.use();
    gl::Uniform1ui(VCT_UNIFORM_SHOWS_VISIBILITY, visibility ? 1 : 0);
    gl::Uniform1ui(VCT_UNIFORM_FILLS_ALL, outdated == Outdated::all ? 1 : 0);
    irradiance_->bindImage(VCT_IMAGE_IRRADIANCE, 0, GL_WRITE_ONLY);
    dispatchOverFaces(voxels, outdated == Outdated::all);
    // The last pass of the frame fetches the bricks.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void Irradiance::chooseFaces(const DirectionalVoxels& voxels, const GBuffer::Targets& surface) const {
    markLookups_.use();
    surface.normal->bind(VCT_TEX_G_NORMAL);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    lastLookups_->bindImage(VCT_IMAGE_LAST_LOOKUPS, 0, GL_WRITE_ONLY);
    // Each group has 8 x 8 invocations, and each invocation a tile of 8 x 8 pixels.
    const glm::uvec2 groups = (glm::uvec2(surface.depth->width(), surface.depth->height()) + 63U) / 64U;
    gl::DispatchCompute(groups.x, groups.y, 1);
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    chooseFaces_.use();
    lastLookups_->bind(VCT_TEX_LAST_LOOKUPS);
    voxels.index().dispatchOverFaces(0);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Irradiance::reserveFaces(const DirectionalVoxels& voxels) {
    const FaceCapacities before = std::exchange(capacities_, voxels.capacities());
    const bool isFirst = idCapacity_ == 0;
    if (!isFirst && before == capacities_) return;
    idCapacity_ = voxels.idCapacity();
    // The buffer begins with the sums over all faces. The faces' histories follow, then the sums of the
    // blocks, and the list of the faces that gather.
    const std::size_t words = VCT_LIGHT_HEADER + (irradianceWords() + 1) * std::size_t{idCapacity_} +
                              4 * std::size_t{capacities_[VCT_BRICK_LEVEL]};
    const std::vector<std::uint32_t> zeros(words);
    gl::Buffer larger("face irradiance", GL_SHADER_STORAGE_BUFFER, zeros.size() * sizeof zeros[0],
                      zeros.data(), GL_DYNAMIC_COPY);
    if (!isFirst) {
        // Faces keep their histories. On PowerVR Rogue, dispatches before a copy may already read the copied
        // values (VoxelPyramid::setCommands()). That cannot happen here, because no dispatch has used the new
        // buffer yet.
        gl::MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        faceIrradiance_.bind(GL_COPY_READ_BUFFER);
        larger.bind(GL_COPY_WRITE_BUFFER);
        std::size_t from = 0, to = 0;
        const auto copy = [&](std::size_t kept, std::size_t oldCount, std::size_t newCount) {
            gl::CopyBufferSubData(
                GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(from * sizeof zeros[0]),
                static_cast<GLintptr>(to * sizeof zeros[0]), static_cast<GLsizeiptr>(kept * sizeof zeros[0]));
            from += oldCount;
            to += newCount;
        };
        copy(VCT_LIGHT_HEADER, VCT_LIGHT_HEADER, VCT_LIGHT_HEADER);
        for (const std::uint32_t list : DirectionalVoxels::baseLists) {
            const std::size_t perFace = irradianceWords(), old = before[list], now = capacities_[list];
            copy(perFace * std::min(old, now), perFace * old, perFace * now);
        }
    }
    faceIrradiance_ = std::move(larger);
}

// The texture of bricks is nearly a cube, so that no side exceeds the 3D texture size that ES 3.1 guarantees,
// for grids up to 256^3.
void Irradiance::reserveBricks(const DirectionalVoxels& voxels, std::uint32_t count) {
    if (irradiance_ && count == brickCapacity_) return;
    brickCapacity_ = count;
    bricksAlong_ = static_cast<std::uint32_t>(std::ceil(std::cbrt(std::max(count, 1U))));
    const std::uint32_t layer = bricksAlong_ * bricksAlong_;
    const std::uint32_t layers = std::max((count + layer - 1) / layer, 1U);
    irradianceSize_ = VCT_BRICK_TEXELS * glm::ivec3(bricksAlong_, bricksAlong_, layers);
    irradiance_ = gl::Texture::make3d("irradiance", GL_RGBA16F, irradianceSize_.x, irradianceSize_.y,
                                      irradianceSize_.z, 1);
    irradiance_->setFilter(GL_LINEAR, GL_LINEAR);
    placesBricks_ = true;
    if (bricks_) return;
    const glm::ivec3 size = blocksSize(voxels);
    bricks_ = gl::Texture::make3d("places of irradiance", GL_R32UI, size.x, size.y, size.z, 1);
    walls_ = gl::Texture::make3d("walls across irradiance", GL_R32UI, size.x, size.y, size.z, 1);
    staticWalls_ = gl::Texture::make3d("static walls", GL_R32UI, size.x, size.y, size.z, 1);
    blockLight_ = gl::Texture::make3d("irradiance of blocks", GL_RGBA16F, size.x, size.y, size.z, 1);
    blockLight_->setFilter(GL_LINEAR, GL_LINEAR);
    lastLookups_ = gl::Texture::make3d("last look-ups of blocks", GL_R32UI, size.x, size.y, size.z, 1);
    gl::clearTexture3d(*lastLookups_, size.z);
}

void Irradiance::uploadUniforms(bool allBounces) const {
    shared::LightStep values{};
    values.frame = step_.frame;
    values.direction = step_.direction;
    values.rays = step_.rays;
    values.initialRays = step_.initialRays;
    values.beginsRound = step_.beginsRound ? 1 : 0;
    values.roundShare = step_.roundShare;
    values.bricksAlong = bricksAlong_;
    // Limits of the history length: of a face that gathers, which keeps at least one step of a history that
    // it has, and of what a face of a new pose inherits.
    values.maxHistory = std::max(step_.history, 1.0F);
    values.maxInheritedHistory = step_.history;
    values.minHistory = step_.minHistory;
    values.bounces = allBounces ? 1.0F : 0.0F;
    values.previousStepWeight = step_.previousStepWeight;
    values.energyCorrection = step_.energyCorrection;
    values.rayBudget = step_.rayBudget;
    values.longEnough = step_.longEnough;
    values.chosenFaces = VCT_LIGHT_HEADER + irradianceWords() * idCapacity_ + 4 * brickCapacity_;
    values.lastActiveFace = values.chosenFaces + idCapacity_ - 1;
    values.blockSums = VCT_LIGHT_HEADER + irradianceWords() * idCapacity_;
    values.smoothing = step_.smoothing;
    // 2^30 units for all faces together, so that the 32-bit sums hold a mean of up to 4, and at most 2^16
    // units for one face.
    values.sumUnits = std::min(65536.0F, 1073741824.0F / static_cast<float>(std::max(idCapacity_, 1U)));
    uniforms_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof values, &values);
}

void Irradiance::bind(const DirectionalVoxels& voxels) const {
    voxels.bindLists();
    faceIrradiance_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACE_IRRADIANCE);
    uniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_LIGHT);
    bricks_->bind(VCT_TEX_BRICKS);
    walls_->bind(VCT_TEX_WALLS);
    irradiance_->bind(VCT_TEX_IRRADIANCE);
    blockLight_->bind(VCT_TEX_BLOCK_LIGHT);
}

void Irradiance::placeBricks(const DirectionalVoxels& voxels, std::uint32_t moved) const {
    clearBricks_.use();
    irradiance_->bindImage(VCT_IMAGE_IRRADIANCE, 0, GL_WRITE_ONLY);
    bricks_->bindImage(VCT_IMAGE_BRICKS, 0, GL_READ_WRITE);
    staticWalls_->bindImage(VCT_IMAGE_STATIC_WALLS, 0, GL_READ_WRITE);
    gl::Uniform1ui(VCT_UNIFORM_CASCADES, moved);
    const glm::uvec3 groups = (glm::max(irradianceSize_, blocksSize(voxels)) + 7) / 8;
    gl::DispatchCompute(groups.x, groups.y, 1);
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    if (moved != 0) markWalls(voxels, voxels.staticList(), *staticWalls_, moved);
    placeBricks_.use();
    staticWalls_->bind(VCT_TEX_WALLS);
    walls_->bindImage(VCT_IMAGE_WALLS, 0, GL_READ_WRITE);
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, VCT_BRICK_LEVEL);
    voxels.index().dispatchOverFaces(VCT_BRICK_LEVEL);
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    if (voxels.hasDynamicObjects())
        markWalls(voxels, voxels.dynamicList(), *walls_, DirectionalVoxels::allCascades);
    walls_->bind(VCT_TEX_WALLS);
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                      GL_SHADER_STORAGE_BARRIER_BIT);
}

void Irradiance::markWalls(const DirectionalVoxels& voxels, std::uint32_t list, const gl::Texture& words,
                           std::uint32_t cascades) const {
    markWalls_.use();
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, list);
    gl::Uniform1ui(VCT_UNIFORM_CASCADES, cascades);
    words.bindImage(VCT_IMAGE_WALLS, 0, GL_READ_WRITE);
    voxels.staticIndex().bind(VCT_TEX_VOXELS);
    voxels.dynamicIndex().bind(VCT_TEX_DYNAMIC_VOXELS);
    voxels.index().dispatchOverFaces(0);
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

std::vector<const gl::Texture*> Irradiance::textures() const {
    if (!irradiance_) return {};
    return {&*irradiance_, &*bricks_, &*walls_, &*staticWalls_, &*blockLight_, &*lastLookups_};
}

}  // namespace vct
