#include "engine/directional/irradiance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "core/error.h"
#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

namespace {

// The size of a texture with one texel per face of each block.
glm::ivec3 blocksSize(const DirectionalVoxels& voxels) {
    return voxels.grid() / VCT_BRICK_SIDE *
           glm::ivec3(DirectionalVoxels::directionsX, DirectionalVoxels::directionsY, voxels.cascades());
}

// Layers of texels of the texture of bricks, at most.
constexpr std::uint32_t bricksHigh = 256;

// Eight cached hits as shaders/directional/face_irradiance.glsl packs them, with so many bits above 16.
struct CachedHits {
    CachedHits(const std::uint32_t* words, std::uint32_t upperBits) {
        for (std::uint32_t i = 0; i < hits.size(); ++i) {
            const std::uint32_t at = upperBits * i;
            hits.at(i) = words[std::size_t{i / 2} * VCT_FACE_GROUP] >> (16 * (i % 2)) & 0xFFFFU;
            const std::uint32_t upper = words[std::size_t{4 + at / 32} * VCT_FACE_GROUP] >> at % 32;
            hits.at(i) |= (upper & ((1U << upperBits) - 1)) << 16U;
        }
    }
    // Into words that are 0.
    void store(std::uint32_t* words, std::uint32_t upperBits) const {
        for (std::uint32_t i = 0; i < hits.size(); ++i) {
            const std::uint32_t at = upperBits * i;
            words[std::size_t{i / 2} * VCT_FACE_GROUP] |= (hits.at(i) & 0xFFFFU) << (16 * (i % 2));
            words[std::size_t{4 + at / 32} * VCT_FACE_GROUP] |= hits.at(i) >> 16U << at % 32;
        }
    }
    std::array<std::uint32_t, 8> hits{};
};

// Sets the uniform of isNearArrived() (shaders/directional/cascades.glsl).
void setArrived(const ArrivedVoxels& arrived, int cascades) {
    constexpr int most = 511;  // of packShift()
    for (std::size_t i = 0; i < static_cast<std::size_t>(cascades); ++i)
        gl::Uniform2ui(VCT_UNIFORM_ARRIVED + static_cast<GLint>(i),
                       shared::packShift(glm::min(arrived.lower.at(i), most)),
                       shared::packShift(glm::min(arrived.upper.at(i), most)));
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

gl::ProgramDescription raysProgram(const std::string& name, const GatherSettings& settings,
                                   const LightFeatures& sources) {
    std::vector<std::string> defines = gatherDefines(settings);
    append(defines, lightProgram(name, sources).defines);
    return {name, {"directional/" + name + ".comp"}, defines};
}

void ArrivedVoxels::add(const CascadeShifts& moves) {
    for (std::size_t i = 0; i < moves.size(); ++i) {
        lower.at(i) += glm::max(-moves.at(i), 0);
        upper.at(i) += glm::max(moves.at(i), 0);
    }
}

void ArrivedVoxels::addAll(int grid) {
    lower.fill(glm::ivec3(grid));
}

Irradiance::Irradiance(const gl::ShaderLibrary& shaders, const GatherSettings& settings, int lightFrames,
                       bool hasObjects, bool listsChange, int cascades, const LightFeatures& sources)
    : settings_(settings),
      lightFrames_(lightFrames),
      cascades_(cascades),
      hasObjects_(hasObjects),
      listsChange_(listsChange),
      schedule_(settings, lightFrames, cascades),
      clearBricks_(shaders, lightProgram("clear_bricks", sources)),
      placeBricks_(shaders, lightProgram("place_bricks", sources)),
      markWalls_(shaders, lightProgram("mark_walls", sources)),
      linkFaces_(shaders, lightProgram("link_faces", sources)),
      sky_(shaders, raysProgram("sky", settings, sources)),
      trace_(shaders, raysProgram("trace", settings, sources)),
      gather_(shaders, raysProgram("gather", settings, sources)),
      refine_(shaders, raysProgram("refine", settings, sources)),
      smoothRows_(shaders, raysProgram("smooth_rows", settings, sources)),
      smooth_(shaders, raysProgram("smooth", settings, sources)),
      fillBricks_(shaders, lightProgram("fill_bricks", sources)),
      emitters_(sources.emitters),
      uniforms_("light step", GL_UNIFORM_BUFFER, sizeof(shared::LightStep), nullptr, GL_DYNAMIC_DRAW) {
    if (listsChange) {
        carryOver_.emplace(shaders, raysProgram("carry_over", settings, sources));
        carryHits_.emplace(shaders, raysProgram("carry_hits", settings, sources));
        traceMoving_.emplace(shaders, raysProgram("trace_moving", settings, sources));
    }
    if (cascades > 1) forwardHits_.emplace(shaders, raysProgram("forward_hits", settings, sources));
    if (cascades > 1) listVisited_.emplace(shaders, raysProgram("list_visited", settings, sources));
    if (cascades > 1) listArrived_.emplace(shaders, lightProgram("list_arrived", sources));
    if (hasObjects) block_.emplace(shaders, raysProgram("block_rays", settings, sources));
    if (emitters_ > 0) findEmitters_.emplace(shaders, emittersProgram(sources));
}

GatherSettings Irradiance::fitting(GatherSettings settings, std::uint32_t ids) {
    GLint largest = 0;
    gl::GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
    if (ids > maxIds(settings.hitBits)) settings.hitBits = 24;
    const auto bytes = [&] {
        const auto hits = static_cast<std::size_t>(settings.directions);
        const std::size_t words = VCT_FACE_SEEN_WORD + VCT_MAX_EMITTER_PARTS / VCT_SEEN_PARTS +
                                  hits * static_cast<std::size_t>(settings.hitBits) / 32 + hits / 8;
        return words * ids * sizeof(std::uint32_t);
    };
    while (settings.directions > 16 && bytes() > static_cast<std::size_t>(largest))
        settings.directions /= 2;
    return settings;
}

void Irradiance::onVoxelsChanged(const LightSchedule::Change& change, const CascadeShifts& shifts,
                                 const Bounds& box) {
    pending_.lists |= change.lists;
    pending_.voxelized |= change.voxelized;
    pending_.light |= change.light;
    pending_.emitters |= change.emitters;
    pending_.sky |= change.sky;
    pending_.all |= change.all;
    pending_.cascades |= change.cascades;
    pendingVoxels_.add(shifts);
    pendingBox_ = united(pendingBox_, box);
    if (change.lists) unplacedCascades_ |= change.all ? DirectionalVoxels::allCascades : change.voxelized;
}

void Irradiance::invalidate() {
    unplacedCascades_ = DirectionalVoxels::allCascades;
    marksAllWalls_ = true;
    schedule_ = LightSchedule(settings_, lightFrames_, cascades_);
    capacities_ = {};
    idCapacity_ = 0;
    forwardTurns_ = forwardedCascades_ = 0;
}

void Irradiance::beginStep(const DirectionalVoxels& voxels, const std::vector<glm::vec4>& objects,
                           bool allBounces) {
    const gl::DebugGroup group("begin light step");
    const LightSchedule::Change change = std::exchange(pending_, {});
    ArrivedVoxels arrived = std::exchange(pendingVoxels_, {});
    const Bounds box = std::exchange(pendingBox_, noBounds);
    plan_ = schedule_.advance(change);
    isOutdated_ = true;
    const bool isFirst = idCapacity_ == 0;
    isBakedStep_ = false;
    // Lists that grow lose the faces that the steps visit.
    if (reserveFaces(voxels, change.voxelized != DirectionalVoxels::allCascades)) plan_.listsVisited = true;
    if (isBakedStep_) schedule_.end();
    reserveBricks(voxels);
    uploadUniforms(voxels, objects, allBounces);
    // The last frame fetched textures that this step writes, and earlier passes wrote data that it reads.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    bind(voxels);
    bool linksObjects = false;
    if (const std::uint32_t placed = std::exchange(unplacedCascades_, 0)) {
        if (carryOver_ && !isFirst && change.lists) carryOver(voxels, change.voxelized);
        const bool isNew =
            std::exchange(marksAllWalls_, false) || change.voxelized == DirectionalVoxels::allCascades;
        if (isNew)
            arrived.addAll(voxels.grid());
        else if (arrived.any())
            listArrived(voxels, arrived);
        placeBricks(voxels, placed, arrived, isNew);
        if (isNew || arrived.any()) linkFaces(voxels, isNew, everywhere);
        linksObjects = !isNew && voxels.hasDynamicObjects();
        if (isFirst) {
            // The bricks are counted by placing them.
            onBricksPlaced(voxels.index().readCommands());
            reserveBricks(voxels);
            uploadUniforms(voxels, objects, allBounces);
            bind(voxels);
            if (std::exchange(unplacedCascades_, 0) != 0)
                placeBricks(voxels, DirectionalVoxels::allCascades, {}, true);
        }
        placedCascades_ |= placed;
    }
    if (forwardHits_ && !isFirst && (change.voxelized != 0 || forwardTurns_ > 0)) {
        forwardHits(voxels, change.voxelized);
        if (forwardTurns_ == 0) plan_.listsVisited = true;
    }
    if (listVisited_ && (isFirst || change.voxelized != 0 || plan_.listsVisited)) listVisited(voxels, box);
    if (linksObjects) linkFaces(voxels, plan_.visitsAll, box);
    if (plan_.visitsAll) placedCascades_ = DirectionalVoxels::allCascades;
    if (!findEmitters_ || !(plan_.updatesEmitters || plan_.emitterTurns > 1)) return;
    voxels.bindForRays();
    run(*findEmitters_, voxels);
}

void Irradiance::run(const gl::Program& program, const DirectionalVoxels& voxels) const {
    program.use();
    dispatchOverVisited(voxels);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Irradiance::runOverAll(const gl::Program& program, const DirectionalVoxels& voxels) const {
    runOver(program, voxels, 0);
}

void Irradiance::runOver(const gl::Program& program, const DirectionalVoxels& voxels,
                         std::uint32_t list) const {
    program.use();
    voxels.index().dispatchOverFaces(static_cast<int>(list));
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Irradiance::dispatchOverVisited(const DirectionalVoxels& voxels) const {
    if (listVisited_) gl::Uniform1ui(VCT_UNIFORM_VISITS_ALL, plan_.visitsAll ? 1 : 0);
    voxels.index().dispatchOverFaces(plan_.visitsAll ? 0 : VCT_LIST_VISITED);
}

void Irradiance::listVisited(const DirectionalVoxels& voxels, const Bounds& box) const {
    voxels.index().emptyFaceList(VCT_LIST_VISITED);
    listVisited_->use();
    gl::Uniform1ui(VCT_UNIFORM_TURNS, forwardTurns_);
    DirectionalVoxels::setChanged(box);
    voxels.index().dispatchOverFaces(0);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void Irradiance::carryOver(const DirectionalVoxels& voxels, std::uint32_t moved) const {
    voxels.staticIndex().bind(VCT_TEX_VOXELS);
    if (moved != 0) voxels.listFresh();
    carryOver_->use();
    for (const std::uint32_t list : {0U, voxels.dynamicList()}) {
        if (list == 0 ? moved == 0 : !voxels.hasDynamicObjects()) continue;
        gl::Uniform1ui(VCT_UNIFORM_LIST, list);
        if (list != 0) {
            voxels.indexOf(list ^ 1U).bind(VCT_TEX_PREVIOUS_VOXELS);
            voxels.pagesOf(list ^ 1U).bind(VCT_TEX_PREVIOUS_PAGES);
        }
        voxels.index().dispatchOverFaces(list == 0 ? VCT_LIST_VISITED : static_cast<int>(list));
        gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    // The new ids of all faces are known before any hit is copied.
    if (voxels.hasDynamicObjects()) runOver(*carryHits_, voxels, voxels.dynamicList());
}

void Irradiance::forwardHits(const DirectionalVoxels& voxels, std::uint32_t moved) {
    // Another move uses the ids of faces that the last one has left, so all turns that are left come now, and
    // then its own.
    const std::uint32_t turns = moved != 0 ? std::max(forwardTurns_, 1U) : 1;
    forwardedCascades_ |= moved;
    if (moved != 0) forwardTurns_ = VCT_FORWARD_TURNS;
    forwardHits_->use();
    gl::Uniform1ui(VCT_UNIFORM_CASCADES, forwardedCascades_);
    gl::Uniform1ui(VCT_UNIFORM_TURNS, turns);
    runOverAll(*forwardHits_, voxels);
    if (--forwardTurns_ == 0) forwardedCascades_ = 0;
}

void Irradiance::findBlockedRays(const DirectionalVoxels& voxels, bool waits) {
    run(*block_, voxels);
    if (!waits) return;
    onRaysBlocked(voxels.index().readCommands().mostBlockedRays);
    if (blocked_ <= blockedCapacity_) return;
    reserveFaces(voxels, true);
    bind(voxels);
    uniforms_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, offsetof(shared::LightStep, blockedCapacity),
                      sizeof blockedCapacity_, &blockedCapacity_);
    voxels.index().resetBlockedRays();
    run(*block_, voxels);
}

void Irradiance::gather(const DirectionalVoxels& voxels, bool waits) {
    const gl::DebugGroup group("gather");
    bind(voxels);
    voxels.bindForRays();
    if (plan_.updatesSky) runOverAll(sky_, voxels);
    if (plan_.traces && capacities_[0] > 0) run(trace_, voxels);
    if (plan_.traces && voxels.hasDynamicObjects()) runOver(*traceMoving_, voxels, voxels.dynamicList());
    if (block_ && plan_.findsBlocked) findBlockedRays(voxels, waits);
    for (int bounce = 0; bounce < plan_.bounces; ++bounce) {
        run(gather_, voxels);
        if (plan_.refiningStep >= 0) run(refine_, voxels);
        run(smoothRows_, voxels);
        run(smooth_, voxels);
    }
}

void Irradiance::fillBricks(const DirectionalVoxels& voxels, bool visibility) {
    std::uint32_t placed = std::exchange(placedCascades_, 0);
    if (showsVisibility_ != visibility) placed = DirectionalVoxels::allCascades;
    showsVisibility_ = visibility;
    isOutdated_ = false;
    const gl::DebugGroup group("fill bricks");
    bind(voxels);
    fillBricks_.use();
    gl::Uniform1ui(VCT_UNIFORM_SHOWS_VISIBILITY, visibility ? 1 : 0);
    bricks_->bindImage(VCT_IMAGE_BRICKS, 0, GL_WRITE_ONLY);
    if (placed != 0) fillFrom(voxels, placed, true);
    if (placed != DirectionalVoxels::allCascades) fillFrom(voxels, ~placed, false);
    // The last pass of the frame fetches the bricks.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void Irradiance::fillFrom(const DirectionalVoxels& voxels, std::uint32_t cascades, bool visitsAll) const {
    gl::Uniform1ui(VCT_UNIFORM_PLACED, cascades);
    if (listVisited_) gl::Uniform1ui(VCT_UNIFORM_VISITS_ALL, visitsAll ? 1 : 0);
    voxels.index().dispatchOverFaces(visitsAll ? 0 : VCT_LIST_VISITED);
}

std::size_t Irradiance::hitWords(std::uint32_t ids) const {
    const std::size_t groups = (ids + VCT_FACE_GROUP - 1) / VCT_FACE_GROUP;
    return groups * VCT_FACE_GROUP * static_cast<std::size_t>(settings_.directions) *
           static_cast<std::size_t>(settings_.hitBits) / 32;
}

bool Irradiance::reserveFaces(const DirectionalVoxels& voxels, bool keepsHits) {
    const FaceCapacities before = std::exchange(capacities_, voxels.capacities());
    const std::uint32_t oldIds = std::exchange(idCapacity_, voxels.idCapacity());
    if (!hasBitsFor(idCapacity_))
        throw Error("the scene covers faces of voxels with " + std::to_string(idCapacity_) +
                    " ids, of which there are " + std::to_string(maxIds(settings_.hitBits)) +
                    "; use a coarser grid");
    const std::uint32_t blockedBefore = blockedCapacity_;
    if (hasObjects_) {
        // All rays of a small scene, 1/64 of those of a large one, or as many as there were.
        const std::uint32_t faces = capacities_[0];
        const std::uint32_t all = static_cast<std::uint32_t>(settings_.directions + 2) * faces;
        blockedCapacity_ = std::max({blockedCapacity_, blocked_, all / 64, std::min(all, 1U << 16U)});
        // With cascades a position has 22 bits (shaders/directional/face_irradiance.glsl).
        if (forwardHits_) blockedCapacity_ = std::min(blockedCapacity_, 1U << 22U);
    }
    const bool grows = before != capacities_;
    if (oldIds != 0 && !grows && blockedBefore == blockedCapacity_) return false;
    // The buffer begins with the faces' words. The hits follow, and the rays that moving objects block.
    const std::size_t perFace = irradianceWords();
    std::vector<std::uint32_t> words(perFace * idCapacity_ + hitWords(idCapacity_) + blockedCapacity_);
    if (oldIds != 0) {
        // Faces keep their light and their hits, with other ids. This is rare enough to wait for the GPU.
        // If all cascades were voxelized again, rays may have missed static faces that did not fit into the
        // lists, so all are traced again.
        std::vector<std::uint32_t> old(perFace * oldIds + hitWords(oldIds));
        faceIrradiance_.read(old.data(), old.size() * sizeof old[0]);
        std::vector<std::uint32_t> newId(oldIds);
        std::size_t from = 0, to = 0;
        for (const std::uint32_t list : DirectionalVoxels::baseLists) {
            for (std::size_t i = 0; i < std::min(before[list], capacities_[list]); ++i)
                newId[from + i] = static_cast<std::uint32_t>(to + i);
            from += before[list];
            to += capacities_[list];
        }
        std::uint32_t* const hits = &words[perFace * idCapacity_];
        const std::uint32_t* const oldHits = &old[perFace * oldIds];
        const auto directions = static_cast<std::uint32_t>(settings_.directions),
                   bits = static_cast<std::uint32_t>(settings_.hitBits), nearBit = 1U << (bits - 1);
        for (std::uint32_t id = 0; id < oldIds; ++id) {
            std::copy_n(old.begin() + static_cast<std::ptrdiff_t>(perFace * id), perFace,
                        words.begin() + static_cast<std::ptrdiff_t>(perFace * newId[id]));
            // The blocked rays are found again.
            words[perFace * newId[id] + VCT_FACE_BLOCKED_COUNTS_WORD] &= VCT_FACE_NOT_BLOCKED;
            if (!keepsHits)
                std::fill_n(
                    words.begin() + static_cast<std::ptrdiff_t>(perFace * newId[id] + VCT_FACE_SKY_WORD), 3,
                    0);
            for (std::uint32_t octet = 0; octet < directions / 8 && keepsHits; ++octet) {
                CachedHits eight(oldHits + shared::hitsWord(id, octet, directions, bits), bits - 16);
                for (std::uint32_t& hit : eight.hits) {
                    const std::uint32_t near = hit & nearBit, code = hit & ~nearBit;
                    if (code >= VCT_HIT_FACE) hit = near | (VCT_HIT_FACE + newId.at(code - VCT_HIT_FACE));
                }
                eight.store(hits + shared::hitsWord(newId[id], octet, directions, bits), bits - 16);
            }
        }
    }
    if (const auto baked = std::exchange(baked_, {})) isBakedStep_ = takeBaked(*baked, voxels, words);
    faceIrradiance_ = {};
    faceIrradiance_ = gl::Buffer("face irradiance", GL_SHADER_STORAGE_BUFFER, words.size() * sizeof words[0],
                                 words.data(), GL_DYNAMIC_COPY);
    return grows;
}

namespace {

bool isBefore(const BakedLight::Face& face, std::uint32_t entry) {
    return face.entry < entry;
}

}  // namespace

bool Irradiance::takeBaked(const BakedLight& light, const DirectionalVoxels& voxels,
                           std::vector<std::uint32_t>& words) const {
    bool isComplete = isBakedCurrent_;
    for (const auto& [entry, id] : voxels.readBaseFaces()) {
        const auto face = std::lower_bound(light.faces.begin(), light.faces.end(), entry, isBefore);
        if (id >= capacities_[0] || face == light.faces.end() || face->entry != entry) {
            isComplete = false;
            continue;
        }
        const std::size_t at = std::size_t{irradianceWords()} * id;
        std::copy(face->shown.begin(), face->shown.end(),
                  words.begin() + static_cast<std::ptrdiff_t>(at + VCT_FACE_SHOWN_WORD));
        words[at + VCT_FACE_SIGHT_WORD] = face->sight;
    }
    return isComplete;
}

std::vector<BakedLight::Face> Irradiance::bake(const DirectionalVoxels& voxels) const {
    std::vector<std::uint32_t> words(std::size_t{irradianceWords()} * idCapacity_);
    faceIrradiance_.read(words.data(), words.size() * sizeof words[0]);
    std::vector<BakedLight::Face> faces;
    for (const auto& [entry, id] : voxels.readBaseFaces()) {
        if (id >= capacities_[0]) continue;
        const std::size_t at = std::size_t{irradianceWords()} * id, shown = at + VCT_FACE_SHOWN_WORD;
        faces.push_back({entry, {words[shown], words[shown + 1]}, words[at + VCT_FACE_SIGHT_WORD]});
    }
    std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.entry < b.entry; });
    return faces;
}

void Irradiance::onBricksPlaced(const shared::CommandLists& found) {
    // An object that turns may give all layers to its bricks and to those of the surface beside it.
    const shared::LevelCommands& blocks = found.lists[VCT_BRICK_LEVEL];
    const std::uint32_t moving = (blocks.faceCount - std::min(blocks.staticFaces, blocks.faceCount)) /
                                 static_cast<std::uint32_t>(cascades_);
    for (std::size_t i = 0; i < brickRooms_.size(); ++i) {
        const std::uint32_t count = found.brickLayers[i];
        if (i > 0 && count == 0) continue;  // the room is not used
        std::uint32_t& room = brickRooms_.at(i).layers;
        // Counts are read frames later, so room is added before it runs out.
        if (listsChange_ ? count + count / 32 < room : count <= room) continue;
        // Layers stay empty where a brick would go on in the next column of the texture.
        const std::uint32_t unused = VCT_BRICK_TEXELS * (count / (bricksHigh - 16) + 1);
        room = count + unused + (listsChange_ ? count / 20 + 128 + 3 * VCT_BRICK_TEXELS * moving : 0);
        unplacedCascades_ = DirectionalVoxels::allCascades;
    }
}

// No side of the texture of bricks exceeds the 3D texture size that ES 3.1 guarantees, for grids up to 256^3.
void Irradiance::reserveBricks(const DirectionalVoxels& voxels) {
    if (bricks_ && unplacedCascades_ != DirectionalVoxels::allCascades) return;
    std::uint32_t layers = 0;
    for (shared::BrickRoom& room : brickRooms_) {
        room.firstLayer = layers;
        layers += room.layers;
    }
    if (bricks_ && layers == brickLayers_) return;
    brickLayers_ = layers;
    constexpr std::uint32_t maxAlong = bricksHigh / VCT_BRICK_TEXELS;
    const std::uint32_t columns = std::max((layers + bricksHigh - 1) / bricksHigh, 1U),
                        rows = (columns + maxAlong - 1) / maxAlong, along = (columns + rows - 1) / rows;
    // As high as these columns need to be, but not lower than a brick.
    const std::uint32_t high =
        std::max<std::uint32_t>((layers + along * rows - 1) / (along * rows), VCT_BRICK_TEXELS);
    const glm::ivec3 size(VCT_BRICK_TEXELS * along, VCT_BRICK_TEXELS * rows, high);
    bricks_ = gl::Texture::make3d("bricks", GL_RGBA16F, size.x, size.y, size.z, 1);
    bricks_->setFilter(GL_LINEAR, GL_LINEAR);
    // Filtering in a brick may also fetch the texels beside it, with a weight of 0. These may be of no brick,
    // but have to be numbers.
    gl::clearTexture3d(*bricks_, size.z);
    if (brickPlaces_) return;
    const glm::ivec3 faces = blocksSize(voxels);
    brickPlaces_ = gl::Texture::make3d("places of bricks", GL_R32UI, faces.x, faces.y, faces.z, 1);
    // A brick has two words for walls.
    walls_ = gl::Texture::make3d("walls across irradiance", GL_R32UI, faces.x, faces.y, 2 * faces.z, 1);
    if (voxels.cascades() == 1)
        staticWalls_ = gl::Texture::make3d("static walls", GL_R32UI, faces.x, faces.y, 2 * faces.z, 1);
}

// The layout std140 aligns arrays of structures to 16 bytes.
static_assert(offsetof(shared::LightStep, bricks) % 16 == 0 && offsetof(shared::LightStep, object) % 16 == 0);

void Irradiance::uploadUniforms(const DirectionalVoxels& voxels, const std::vector<glm::vec4>& objects,
                                bool allBounces) const {
    shared::LightStep values{};
    values.frame = plan_.step;
    values.rays = static_cast<std::uint32_t>(settings_.rays);
    values.movingRays = plan_.movingRays;
    values.minMovingRays = plan_.minMovingRays;
    if (plan_.refiningStep >= 0) {
        values.firstRefining = static_cast<std::uint32_t>(plan_.refiningStep * settings_.rays);
        values.refiningRays = static_cast<std::uint32_t>(settings_.rays);
        values.refiningShare = 1.0F / static_cast<float>(plan_.refiningStep + 1);
        // A mean over few steps is noisy, so it is shown by degrees.
        const float done =
            static_cast<float>(plan_.refiningStep + 1) / static_cast<float>(plan_.refiningSteps);
        values.refiningWeight = done * done;
    }
    values.interrupts = plan_.interrupts ? 1 : 0;
    values.endsRefinement = plan_.endsRefinement() ? 1 : 0;
    values.startsDark = plan_.startsDark ? 1 : 0;
    values.visitedCascades = plan_.visitedCascades;
    values.bounces = allBounces ? 1.0F : 0.0F;
    std::copy(brickRooms_.begin(), brickRooms_.end(), values.bricks);
    values.firstHit = irradianceWords() * idCapacity_;
    values.firstBlocked = values.firstHit + static_cast<std::uint32_t>(hitWords(idCapacity_));
    values.blockedCapacity = blockedCapacity_;
    values.visitsSince = plan_.visitsSince;
    values.emitterTurns = plan_.emitterTurns;
    values.objectCount = static_cast<std::uint32_t>(objects.size());
    std::copy(objects.begin(), objects.end(), values.object);
    values.objectsLow = glm::vec4(glm::vec3(voxels.objects().min), 0.0F);
    values.objectsHigh = glm::vec4(glm::vec3(voxels.objects().max), 0.0F);
    uniforms_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof values, &values);
}

void Irradiance::bind(const DirectionalVoxels& voxels) const {
    voxels.bindLists();
    faceIrradiance_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACE_IRRADIANCE);
    uniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_LIGHT);
    brickPlaces_->bind(VCT_TEX_BRICK_PLACES);
    walls_->bind(VCT_TEX_WALLS);
    bricks_->bind(VCT_TEX_BRICKS);
}

void Irradiance::placeBricks(const DirectionalVoxels& voxels, std::uint32_t placed,
                             const ArrivedVoxels& arrived, bool marksAll) const {
    clearBricks_.use();
    brickPlaces_->bindImage(VCT_IMAGE_BRICK_PLACES, 0, GL_READ_WRITE);
    if (staticWalls_) staticWalls_->bindImage(VCT_IMAGE_STATIC_WALLS, 0, GL_READ_WRITE);
    gl::Uniform1ui(VCT_UNIFORM_PLACED, placed);
    setArrived(arrived, voxels.cascades());
    const glm::uvec3 groups = (blocksSize(voxels) + 3) / 4;
    gl::DispatchCompute(groups.x, groups.y, groups.z);
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                      GL_SHADER_STORAGE_BARRIER_BIT);
    if (arrived.any()) markWalls(voxels, 0, staticWalls_ ? *staticWalls_ : *walls_, marksAll);
    placeBricks_.use();
    if (staticWalls_) staticWalls_->bind(VCT_TEX_WALLS);
    walls_->bindImage(VCT_IMAGE_WALLS, 0, GL_READ_WRITE);
    bricks_->bindImage(VCT_IMAGE_BRICKS, 0, GL_WRITE_ONLY);
    gl::Uniform1ui(VCT_UNIFORM_PLACED, placed);
    voxels.index().dispatchOverFaces(VCT_BRICK_LEVEL);
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    if (voxels.hasDynamicObjects()) markWalls(voxels, voxels.dynamicList(), *walls_, true);
    walls_->bind(VCT_TEX_WALLS);
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                      GL_SHADER_STORAGE_BARRIER_BIT);
}

void Irradiance::markWalls(const DirectionalVoxels& voxels, std::uint32_t list, const gl::Texture& words,
                           bool marksAll) const {
    markWalls_.use();
    gl::Uniform1ui(VCT_UNIFORM_LIST, list);
    if (listVisited_) gl::Uniform1ui(VCT_UNIFORM_VISITS_ALL, marksAll ? 1 : 0);
    words.bindImage(VCT_IMAGE_WALLS, 0, GL_READ_WRITE);
    voxels.bindIndices();
    voxels.index().dispatchOverFaces(marksAll ? static_cast<int>(list) : VCT_LIST_VISITED);
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                      GL_SHADER_STORAGE_BARRIER_BIT);
}

void Irradiance::listArrived(const DirectionalVoxels& voxels, const ArrivedVoxels& arrived) const {
    voxels.index().emptyFaceList(VCT_LIST_VISITED);
    listArrived_->use();
    setArrived(arrived, voxels.cascades());
    voxels.index().dispatchOverFaces(0);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void Irradiance::linkFaces(const DirectionalVoxels& voxels, bool visitsAll, const Bounds& box) const {
    linkFaces_.use();
    if (listVisited_) gl::Uniform1ui(VCT_UNIFORM_VISITS_ALL, visitsAll ? 1 : 0);
    DirectionalVoxels::setChanged(box);
    voxels.bindForRays();
    voxels.index().dispatchOverFaces(visitsAll ? 0 : VCT_LIST_VISITED);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

std::vector<const gl::Texture*> Irradiance::textures() const {
    if (!bricks_) return {};
    std::vector<const gl::Texture*> textures{&*bricks_, &*brickPlaces_, &*walls_};
    if (staticWalls_) textures.push_back(&*staticWalls_);
    return textures;
}

}  // namespace vct
