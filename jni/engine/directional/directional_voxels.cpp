#include "engine/directional/directional_voxels.h"

#include <algorithm>
#include <cstddef>
#include <set>

#include "core/error.h"
#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

gl::ProgramDescription clearDynamicProgram(bool emission) {
    return {"directional/clear_dynamic", {"directional/clear_dynamic.comp"}, emissionDefines(emission)};
}

gl::ProgramDescription clearBlocksProgram() {
    return {"directional/clear_blocks", {"directional/clear_blocks.comp"}, {}};
}

gl::ProgramDescription fillBlocksProgram(bool emission) {
    return {"directional/fill_blocks", {"directional/fill_blocks.comp"}, emissionDefines(emission)};
}

gl::ProgramDescription resolveProgram(bool emission) {
    return {"directional/resolve", {"directional/resolve.comp"}, emissionDefines(emission)};
}

gl::ProgramDescription extentsProgram(bool emission) {
    return {"directional/extents", {"directional/extents.comp"}, emissionDefines(emission)};
}

gl::ProgramDescription resetListsProgram() {
    return {"directional/reset_lists", {"directional/reset_lists.comp"}, {}};
}

gl::ProgramDescription markStaticProgram() {
    return {"directional/mark_static", {"directional/mark_static.comp"}, {}};
}

gl::ProgramDescription unlistStaticProgram(bool emission) {
    return {"directional/unlist_static", {"directional/unlist_static.comp"}, emissionDefines(emission)};
}

gl::ProgramDescription scrollProgram(bool emission) {
    return {"directional/scroll", {"directional/scroll.comp"}, emissionDefines(emission)};
}

gl::ProgramDescription listBlocksProgram() {
    return {"directional/list_blocks", {"directional/list_blocks.comp"}, {}};
}

gl::ProgramDescription listFreeProgram() {
    return {"directional/list_free", {"directional/list_free.comp"}, {}};
}

gl::ProgramDescription listFreshProgram() {
    return {"directional/list_fresh", {"directional/list_fresh.comp"}, {}};
}

namespace {

// The position of a listed face's voxel in an array of side^2 voxels per layer.
std::size_t placeIn(std::uint32_t side, std::uint32_t entry) {
    const glm::uvec3 voxel = shared::unpackFaceVoxel(entry);
    return voxel.x + side * (voxel.y + std::size_t{side} * voxel.z);
}

// The position of the first page.
std::uint32_t firstPageOf(const shared::CommandLists& commands) {
    return commands.firstFreePage - commands.pageCapacity * VCT_PAGE_WORDS;
}

// Adds the pages from one number on to the free ones.
void addFreePages(shared::CommandLists& commands, std::vector<std::uint32_t>& data, std::uint32_t from) {
    for (std::uint32_t page = from; page < commands.pageCapacity; ++page)
        data[commands.firstFreePage + commands.freePages++] = firstPageOf(commands) + page * VCT_PAGE_WORDS;
}

}  // namespace

float faceSumUnits(std::size_t triangles) {
    const std::size_t room = 0xFFFFFFFFU / std::max<std::size_t>(triangles, 1);
    return static_cast<float>(std::clamp<std::size_t>(room, 1, 65536));
}

DirectionalVoxels::DirectionalVoxels(const gl::ShaderLibrary& shaders, int grid, int cascades,
                                     std::uint32_t listCapacity, bool dynamicObjects, bool emission)
    : cascades_(cascades),
      dynamicObjects_(dynamicObjects),
      emission_(emission),
      index_(shaders, grid, listCapacity,
             dynamicObjects ? VoxelPyramid::Kind::staticAndDynamicFaces : VoxelPyramid::Kind::staticFaces,
             cascades),
      blocks_(gl::Texture::make3d("blocks of voxels", GL_RGBA16UI, grid / VCT_BRICK_SIDE,
                                  grid / VCT_BRICK_SIDE,
                                  (dynamicObjects ? 2 : 1) * cascades * grid / VCT_BRICK_SIDE, 1)),
      markStatic_(shaders, markStaticProgram()),
      fillBlocks_(shaders, fillBlocksProgram(emission)),
      resolve_(shaders, resolveProgram(emission)),
      extents_(shaders, extentsProgram(emission)) {
    if (!dynamicObjects && cascades == 1) return;
    clearDynamic_ = gl::Program(shaders, clearDynamicProgram(emission));
    clearBlocks_ = gl::Program(shaders, clearBlocksProgram());
    resetLists_ = gl::Program(shaders, resetListsProgram());
    if (cascades > 1) {
        unlistStatic_ = gl::Program(shaders, unlistStaticProgram(emission));
        scroll_ = gl::Program(shaders, scrollProgram(emission));
        listFree_ = gl::Program(shaders, listFreeProgram());
        listFresh_ = gl::Program(shaders, listFreshProgram());
        listBlocks_ = gl::Program(shaders, listBlocksProgram());
    }
}

std::size_t DirectionalVoxels::bytesFor(int grid, int cascades, std::uint32_t listCapacity) {
    const int blocks = grid / VCT_BRICK_SIDE;
    return VoxelPyramid::bytesFor(grid, listCapacity, VoxelPyramid::Kind::staticFaces, cascades) +
           gl::textureBytes(GL_RGBA16UI, blocks, blocks, cascades * blocks, 1);
}

Resources DirectionalVoxels::resources() const {
    Resources resources = index_.resources();
    add(resources, blocks_);
    add(resources, faceData_);
    if (faceSums_.bytes() > 0) add(resources, faceSums_);
    for (const std::vector<gl::Texture>* textures : {&dynamicIndices_, &dynamicPages_})
        for (const gl::Texture& texture : *textures)
            add(resources, texture);
    return resources;
}

const gl::Texture& DirectionalVoxels::indexOf(std::uint32_t list) const {
    return list < VCT_LIST_DYNAMIC || dynamicIndices_.empty() ? index_.texture()
                                                              : dynamicIndices_[list - VCT_LIST_DYNAMIC];
}

const gl::Texture& DirectionalVoxels::pagesOf(std::uint32_t list) const {
    return dynamicPages_.empty() ? index_.texture() : dynamicPages_[list - VCT_LIST_DYNAMIC];
}

std::uint32_t DirectionalVoxels::firstFaceWord() const {
    return (cascades_ > 1 ? VCT_PAGED_BLOCK_WORDS : VCT_BLOCK_WORDS) * blockCount();
}

std::uint32_t DirectionalVoxels::blockCount() const {
    const auto side = static_cast<std::uint32_t>(grid() / VCT_BRICK_SIDE);
    return side * side * side * static_cast<std::uint32_t>(cascades_);
}

// Sets the positions of the lists and of the blocks' bits in faceData(), in words
// (shaders/directional/face_lists.glsl).
void DirectionalVoxels::placeLists(shared::CommandLists& commands) const {
    const std::uint32_t groups = (idCapacity() + VCT_FACE_GROUP - 1) / VCT_FACE_GROUP;
    std::uint32_t next = firstFaceWord() + groups * VCT_FACE_GROUP * (faceWords() + 1), firstId = 0;
    for (const std::uint32_t list : baseLists) {
        shared::LevelCommands& base = commands.lists[list];
        base.firstFace = next + firstId;
        base.firstId = firstId;
        base.faceCapacity = capacities_[list];
        firstId += capacities_[list];
    }
    // Three bits per static id.
    commands.lists[0].firstMask = next + firstId;
    next += 3 * ((capacities_[0] + 31) / 32);
    shared::LevelCommands& visited = commands.lists[VCT_LIST_VISITED];
    visited.firstFace = next + firstId;
    visited.faceCapacity = cascades_ > 1 ? capacities_[0] + capacities_[VCT_LIST_DYNAMIC] : 0;
    next += visited.faceCapacity;
    shared::LevelCommands& blocks = commands.lists[VCT_BRICK_LEVEL];
    blocks.firstFace = next + firstId;
    blocks.faceCapacity = capacities_[VCT_BRICK_LEVEL];
    blocks.firstMask = blocks.firstFace + blocks.faceCapacity;
    commands.pageCapacity = pageCapacity_;
    commands.firstFreePage = blocks.firstMask + (blockCount() + 3) / 4 + pageCapacity_ * VCT_PAGE_WORDS;
}

std::size_t DirectionalVoxels::words() const {
    shared::CommandLists commands{};
    placeLists(commands);
    return std::size_t{commands.firstFreePage} + pageCapacity_;
}

void DirectionalVoxels::reset(const FaceCapacities& capacities, std::uint32_t pages) {
    const gl::DebugGroup group("clear voxels");
    index_.clearTexture();
    // The old buffer is released first, so that the two need not fit into memory together.
    faceData_ = {};
    capacities_ = capacities;
    pageCapacity_ = pages;
    makeDynamicIndices();
    pose_ = 0;
    shared::CommandLists commands = index_.initialCommands();
    placeLists(commands);
    std::vector<std::uint32_t> data(words());
    std::fill_n(data.begin() + commands.lists[0].firstFace, capacities[0], VCT_FREE_FACE);
    addFreePages(commands, data, 0);
    faceData_ = gl::Buffer("voxel faces and lists", GL_SHADER_STORAGE_BUFFER, data.size() * sizeof data[0],
                           data.data(), GL_DYNAMIC_COPY);
    index_.setCommands(commands);
    makeSums(capacities[0], true);
}

void DirectionalVoxels::makeSums(std::uint32_t staticFaces, bool byId) {
    // The old buffer is released first, so that the two need not fit into memory together.
    faceSums_ = {};
    sumsById_ = byId;
    const std::size_t faces = staticFaces + 2 * std::size_t{capacities_[VCT_LIST_DYNAMIC]};
    const std::vector<std::uint32_t> sums(std::max(faces * sumWords(), std::size_t{1}));
    faceSums_ = gl::Buffer("sums of voxel faces", GL_SHADER_STORAGE_BUFFER, sums.size() * sizeof sums[0],
                           sums.data(), GL_DYNAMIC_COPY);
    index_.setStaticSums(staticFaces, byId);
}

void DirectionalVoxels::reserveSums(std::uint32_t staticFaces) {
    if (staticFaces <= sumCapacity_) return;
    sumCapacity_ = staticFaces;
    makeSums(sumCapacity_, false);
}

void DirectionalVoxels::shrinkSums() {
    if (!dynamicObjects_ && cascades_ == 1) {
        faceSums_ = {};
        return;
    }
    // One cascade moves at a time, by an eighth of its side along one axis or more. It has room for a third
    // of its faces, because they lie unevenly.
    if (cascades_ > 1)
        sumCapacity_ =
            std::max(sumCapacity_, capacities_[0] / (3 * static_cast<std::uint32_t>(cascades_)) + 256);
    makeSums(sumCapacity_, false);
}

void DirectionalVoxels::markStatic() const {
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    bindLists();
    markStatic_.use();
    gl::DispatchCompute(1, 1, 1);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void DirectionalVoxels::grow(const FaceCapacities& capacities, std::uint32_t pages) {
    shared::CommandLists commands = index_.readCommands();
    const shared::CommandLists old = commands;
    std::vector<std::uint32_t> before(faceData_.bytes() / sizeof(std::uint32_t));
    faceData_.read(before.data(), faceData_.bytes());
    capacities_ = capacities;
    pageCapacity_ = pages;
    makeDynamicIndices();
    placeLists(commands);
    std::vector<std::uint32_t> after(words());
    const auto copy = [&](std::size_t from, std::size_t to, std::size_t count) {
        std::copy_n(before.begin() + static_cast<std::ptrdiff_t>(from), count,
                    after.begin() + static_cast<std::ptrdiff_t>(to));
    };
    copy(0, 0, firstFaceWord());
    // The pages follow each other, so that all of their positions change alike.
    const std::uint32_t firstPage = firstPageOf(commands), oldFirstPage = firstPageOf(old);
    const auto moved = [=](std::uint32_t page) { return page == 0 ? 0 : page - oldFirstPage + firstPage; };
    copy(oldFirstPage, firstPage, std::size_t{old.pageCapacity} * VCT_PAGE_WORDS);
    for (std::uint32_t block = 0; block < blockCount() && cascades_ > 1; ++block) {
        std::uint32_t& page = after[std::size_t{block} * VCT_PAGED_BLOCK_WORDS + VCT_PAGED_BLOCK_WORDS - 1];
        page = moved(page);
    }
    commands.freePages = old.freePages - std::min(old.takenPages, old.freePages);
    commands.takenPages = 0;
    for (std::uint32_t i = 0; i < commands.freePages; ++i)
        after[commands.firstFreePage + i] = moved(before[old.firstFreePage + i]);
    addFreePages(commands, after, old.pageCapacity);
    for (const std::uint32_t list : baseLists) {
        const bool isOlder = list >= VCT_LIST_DYNAMIC && list != dynamicList();
        shared::LevelCommands& now = commands.lists[list];
        const shared::LevelCommands& was = old.lists[list];
        const std::uint32_t count = isOlder ? 0 : std::min(was.faceCount, was.faceCapacity);
        copy(was.firstFace, now.firstFace, count);
        for (std::uint32_t i = 0; i < count; ++i) {
            after[radianceWord(now.firstId + i)] = before[radianceWord(was.firstId + i)];
            copy(faceWord(was.firstId + i), faceWord(now.firstId + i), faceWords());
        }
        now.faceCount = count;
        now.staticFaces = std::min(now.staticFaces, count);
        if (list == 0) continue;  // its ids stay
        const auto first = after.begin() + static_cast<std::ptrdiff_t>(now.firstFace);
        if (count > 0) writeIndex(list, now.firstId, {first, first + count});
    }
    const std::uint32_t oldBits = (old.lists[0].faceCapacity + 31) / 32, bits = (capacities_[0] + 31) / 32;
    for (const std::uint32_t i : {0U, 1U, 2U})
        copy(old.lists[0].firstMask + i * oldBits, commands.lists[0].firstMask + i * bits, oldBits);
    std::fill_n(after.begin() + commands.lists[0].firstFace + old.lists[0].faceCapacity,
                capacities_[0] - old.lists[0].faceCapacity, VCT_FREE_FACE);
    commands.unplacedFaces = 0;
    commands.lists[VCT_LIST_VISITED].faceCount = 0;
    shared::LevelCommands& now = commands.lists[VCT_BRICK_LEVEL];
    now.faceCount = std::min(now.faceCount, old.lists[VCT_BRICK_LEVEL].faceCapacity);
    now.staticFaces = std::min(now.staticFaces, now.faceCount);
    copy(old.lists[VCT_BRICK_LEVEL].firstFace, now.firstFace, now.faceCount);
    for (std::uint32_t i = 0; i < now.faceCount; ++i) {
        const std::uint32_t entry = after[now.firstFace + i];
        const std::size_t place = placeIn(static_cast<std::uint32_t>(grid() / VCT_BRICK_SIDE), entry);
        after[now.firstMask + place / 4] |= 1U << (8 * (place & 3U) + shared::unpackFace(entry));
    }
    faceData_ = {};
    faceData_ = gl::Buffer("voxel faces and lists", GL_SHADER_STORAGE_BUFFER, after.size() * sizeof after[0],
                           after.data(), GL_DYNAMIC_COPY);
    index_.setCommands(commands);
    shrinkSums();
}

void DirectionalVoxels::makeDynamicIndices() {
    dynamicIndices_.clear();
    dynamicPages_.clear();
    if (!dynamicObjects_) return;
    // As many pages as faces, because a page has a face, but not more than blocks, and the empty one.
    const int side = grid() / VCT_BRICK_SIDE, blocks = side * side * side * cascades_,
              pages = std::min(static_cast<int>(capacities_[VCT_LIST_DYNAMIC]), blocks) + 1,
              depth = VCT_BRICK_SIDE * ((pages + side * side - 1) / (side * side));
    for (int i = 0; i < 2; ++i) {
        dynamicIndices_.push_back(
            gl::Texture::make3d("voxels of dynamic objects", GL_R32UI, grid(), grid(), depth, 1));
        dynamicPages_.push_back(
            gl::Texture::make3d("blocks of dynamic objects", GL_RGBA16UI, side, side, cascades_ * side, 1));
        gl::clearTexture3d(dynamicIndices_.back(), depth);
        gl::clearTexture3d(dynamicPages_.back(), cascades_ * side);
    }
}

// Writes the index of the faces in a list of dynamic objects: shaders/directional/index.glsl. The entries of
// a voxel follow each other.
void DirectionalVoxels::writeIndex(std::uint32_t list, std::uint32_t firstId,
                                   const std::vector<std::uint32_t>& entries) const {
    const auto side = static_cast<std::uint32_t>(grid()), blocks = side / VCT_BRICK_SIDE;
    std::vector<std::uint32_t> cells(indexOf(list).bytes() / sizeof(std::uint32_t));
    std::vector<glm::u16vec4> pages(pagesOf(list).bytes() / sizeof(glm::u16vec4));
    std::uint32_t used = 0;
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
        const glm::uvec3 voxel = shared::unpackFaceVoxel(entries[i]), block = voxel >> 2U;
        glm::u16vec4& page = pages[block.x + blocks * (block.y + std::size_t{blocks} * block.z)];
        if (page == glm::u16vec4(0)) {
            ++used;
            page = {glm::uvec3(used % blocks, used / blocks % blocks, used / (blocks * blocks)) << 2U, 0};
        }
        const glm::uvec3 texel = glm::uvec3(page) + (voxel & 3U);
        std::uint32_t& cell = cells[texel.x + side * (texel.y + std::size_t{side} * texel.z)];
        if (cell == 0) cell = (firstId + i + 1) << VCT_FACE_MASK_BITS;
        cell |= 1U << shared::unpackFace(entries[i]);
    }
    const auto upload = [](const gl::Texture& texture, int depth, GLenum format, GLenum type,
                           const void* texels) {
        texture.bind(VCT_TEX_DYNAMIC_VOXELS);
        gl::TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, texture.width(), texture.height(), depth, format, type,
                          texels);
    };
    upload(indexOf(list), static_cast<int>(cells.size() / (std::size_t{side} * side)), GL_RED_INTEGER,
           GL_UNSIGNED_INT, cells.data());
    upload(pagesOf(list), cascades_ * static_cast<int>(blocks), GL_RGBA_INTEGER, GL_UNSIGNED_SHORT,
           pages.data());
}

// Removes what the last pose has listed, and resets the lists.
void DirectionalVoxels::resetLists(bool withStatic) {
    if (hasDynamicObjects()) {
        clearDynamic_.use();
        setFirstSums();
        bindIndices();
        pagesOf(dynamicList() ^ 1U).bindImage(VCT_IMAGE_PAGES, 0, GL_WRITE_ONLY);
        index_.dispatchOverFaces(0);
    }
    clearBlocks_.use();
    index_.dispatchOverFaces(VCT_BRICK_LEVEL);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    pose_ = 1 - pose_;
    resetLists_.use();
    gl::Uniform1ui(VCT_UNIFORM_STATIC, withStatic ? 1 : 0);
    gl::DispatchCompute(1, 1, 1);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void DirectionalVoxels::beginPose() {
    const gl::DebugGroup group("remove dynamic objects");
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    bindForVoxelization();
    resetLists(false);
}

void DirectionalVoxels::beginMove(const CascadeShifts& shifts, std::uint32_t moved, StaticFaces voxelized) {
    const gl::DebugGroup group("move cascades");
    const bool rebuilds = voxelized == StaticFaces::all;
    if (voxelized != StaticFaces::ofMove) makeSums(capacities_[0], rebuilds);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    bindForVoxelization();
    resetLists(true);
    index_.emptyFaceList(VCT_LIST_VISITED);
    unlistStatic_.use();
    gl::Uniform1ui(VCT_UNIFORM_CASCADES, rebuilds ? allCascades : moved);
    index_.dispatchOverFaces(0);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    const auto setShifts = [&] {
        for (std::size_t i = 0; i < static_cast<std::size_t>(cascades_); ++i)
            gl::Uniform1ui(VCT_UNIFORM_SHIFT + static_cast<GLint>(i), shared::packShift(shifts.at(i)));
    };
    scroll_.use();
    setShifts();
    index_.dispatchOverFaces(VCT_LIST_VISITED);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    index_.emptyFaceList(VCT_LIST_VISITED);
    listFree_.use();
    index_.dispatchOverFaces(0);
    listBlocks_.use();
    setShifts();
    dispatchOverBlocks(cascades_ * grid() / VCT_BRICK_SIDE);
    markStatic();
    gl::MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void DirectionalVoxels::dispatchOverBlocks(int layers) const {
    const auto groups = static_cast<GLuint>((grid() / VCT_BRICK_SIDE + 3) / 4);
    gl::DispatchCompute(groups, groups, static_cast<GLuint>((layers + 3) / 4));
}

std::vector<DirectionalVoxels::BaseFace> DirectionalVoxels::readBaseFaces() const {
    const shared::CommandLists commands = index_.readCommands();
    std::vector<BaseFace> faces;
    for (const std::uint32_t list : {0U, dynamicList()}) {
        const shared::LevelCommands& base = commands.lists[list];
        std::vector<std::uint32_t> entries(std::min(base.faceCount, base.faceCapacity));
        faceData_.read(entries.data(), entries.size() * sizeof entries[0],
                       base.firstFace * sizeof entries[0]);
        for (std::uint32_t i = 0; i < entries.size(); ++i)
            if ((entries[i] & VCT_MERGED_FACE) == 0)
                faces.push_back({entries[i] & ~VCT_FIRST_FACE, base.firstId + i});
    }
    return faces;
}

std::vector<std::uint32_t> DirectionalVoxels::readVoxels() const {
    std::set<std::uint32_t> voxels;
    for (const BaseFace& face : readBaseFaces())
        voxels.insert(shared::packEntry(shared::unpackFaceVoxel(face.entry)));
    return {voxels.begin(), voxels.end()};
}

std::vector<std::uint32_t> DirectionalVoxels::readBlockFaces() const {
    const shared::LevelCommands list = index_.readCommands().lists[VCT_BRICK_LEVEL];
    std::vector<std::uint32_t> faces(std::min(list.faceCount, list.faceCapacity));
    faceData_.read(faces.data(), faces.size() * sizeof faces[0], list.firstFace * sizeof faces[0]);
    return faces;
}

void DirectionalVoxels::resolve(std::uint32_t changed, const Bounds& objects) {
    const gl::DebugGroup group("resolve faces");
    changed_ = united(objects_, objects);
    objects_ = objects;
    bindForVoxelization();
    if (changed != 0 && !sumsById_) listFresh();
    bindIndices();
    if (changed != 0) resolveFaces(sumsById_ ? 0 : VCT_LIST_VISITED);
    if (hasDynamicObjects()) resolveFaces(dynamicList());
    fillBlocks_.use();
    blocks_.bindImage(VCT_IMAGE_BLOCKS, 0, GL_WRITE_ONLY);
    gl::Uniform1ui(VCT_UNIFORM_CASCADES, changed);
    dispatchOverBlocks((hasDynamicObjects() ? 2 : 1) * cascades_ * grid() / VCT_BRICK_SIDE);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void DirectionalVoxels::resolveFaces(std::uint32_t list) const {
    for (const gl::Program* program : {&resolve_, &extents_}) {
        program->use();
        gl::Uniform1ui(VCT_UNIFORM_LIST, list);
        setFirstSums();
        index_.dispatchOverFaces(static_cast<int>(list));
        gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
}

void DirectionalVoxels::setFirstSums() const {
    if (cascades_ == 1) gl::Uniform1ui(VCT_UNIFORM_FIRST_SUMS, firstWithSums());
}

void DirectionalVoxels::setFirstSums(const MaterialPrograms& programs) const {
    if (cascades_ == 1) programs.setUniform(VCT_UNIFORM_FIRST_SUMS, firstWithSums());
}

void DirectionalVoxels::setChanged(const Bounds& box) {
    const std::array<glm::vec3, 2> corners{glm::clamp(box.min, everywhere.min, everywhere.max),
                                           glm::clamp(box.max, everywhere.min, everywhere.max)};
    gl::Uniform3fv(VCT_UNIFORM_CHANGED, 2, &corners[0][0]);
}

void DirectionalVoxels::listFresh() const {
    index_.emptyFaceList(VCT_LIST_VISITED);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    listFresh_.use();
    const std::uint32_t words = (capacities_[0] + 31) / 32;
    gl::DispatchCompute((words + VCT_LIST_GROUP - 1) / VCT_LIST_GROUP + 1, 1, 1);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void DirectionalVoxels::bindIndices() const {
    staticIndex().bind(VCT_TEX_VOXELS);
    dynamicIndex().bind(VCT_TEX_DYNAMIC_VOXELS);
    dynamicPages().bind(VCT_TEX_DYNAMIC_PAGES);
}

void DirectionalVoxels::bindLists() const {
    index_.bindLists();
    faceData_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACES);
}

void DirectionalVoxels::bindForVoxelization() const {
    bindLists();
    faceSums_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACE_SUMS);
}

void DirectionalVoxels::bindForRays() const {
    faceData_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACES);
    bindIndices();
    blocks_.bind(VCT_TEX_BLOCKS);
}

}  // namespace vct
