#include "engine/voxel_pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "core/error.h"
#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/driver_faults.h"

namespace vct {

namespace {

int levelsOf(int grid, VoxelPyramid::Kind kind) {
    return kind == VoxelPyramid::Kind::packed ? static_cast<int>(std::log2(grid)) + 1 : 1;
}

// Directional voxels of the base level are counted, but only their faces are listed.
bool hasEntries(VoxelPyramid::Kind kind, int list) {
    return kind == VoxelPyramid::Kind::packed || list == VCT_BRICK_LEVEL;
}

shared::CommandLists makeInitialCommands(int grid, std::uint32_t baseCapacity, VoxelPyramid::Kind kind,
                                         int cascades) {
    const auto voxels = [=](int level) {
        const std::uint64_t side = static_cast<std::uint64_t>(grid) >> level;
        return side * side * side * static_cast<std::uint64_t>(cascades);
    };
    const std::uint64_t wanted = baseCapacity != 0 ? baseCapacity : 16ULL * grid * grid * cascades;
    shared::CommandLists commands{};
    commands.dynamicList = VCT_LIST_DYNAMIC;
    std::uint32_t firstEntry = 0;
    for (int list = 0; list < VCT_LISTS; ++list) {
        const bool isDynamic = (list & ~1) == VCT_LIST_DYNAMIC;
        // Directional voxels have lists of voxels at the base level and of blocks, and others of faces only.
        const bool isPacked = kind == VoxelPyramid::Kind::packed,
                   isOfBlocks = !isPacked && list == VCT_BRICK_LEVEL,
                   hasFacesOnly = isDynamic || (!isPacked && list == VCT_LIST_VISITED);
        const bool exists = isDynamic ? kind == VoxelPyramid::Kind::staticAndDynamicFaces
                                      : hasFacesOnly || isOfBlocks || list < levelsOf(grid, kind);
        if (!exists) continue;
        shared::LevelCommands& c = commands.lists[list];
        c.groupsY = c.groupsZ = c.faceGroupsY = c.faceGroupsZ = 1;
        c.firstEntry = firstEntry;
        if (hasFacesOnly) continue;
        c.capacity = static_cast<std::uint32_t>(isOfBlocks ? voxels(list) : std::min(wanted, voxels(list)));
        if (hasEntries(kind, list)) firstEntry += c.capacity;
    }
    return commands;
}

std::size_t listBytes(const shared::CommandLists& commands, VoxelPyramid::Kind kind) {
    std::size_t entries = 0;
    for (int list = 0; list < VCT_LISTS; ++list)
        if (hasEntries(kind, list)) entries += commands.lists[list].capacity;
    return entries * sizeof(std::uint32_t);
}

// Drivers with this fault dispatch by copies of the commands.
bool missesCounts() {
    return !gl::faultsOf(gl::glString(GL_RENDERER), gl::glString(GL_VERSION)).indirectDispatches.empty();
}

}  // namespace

gl::ProgramDescription packedClearProgram() {
    return {"packed/clear", {"packed/clear.comp"}, {}};
}

VoxelPyramid::VoxelPyramid(const gl::ShaderLibrary& shaders, int grid, std::uint32_t baseCapacity, Kind kind,
                           int cascades)
    : grid_(grid),
      depth_(cascades == 1 ? grid : 1),
      levels_(levelsOf(grid, kind)),
      texture_(gl::Texture::make3d("voxels", GL_R32UI, depth_, depth_, depth_, levelsOf(grid, kind))),
      initialCommands_(makeInitialCommands(grid, baseCapacity, kind, cascades)),
      commands_("voxel commands", GL_SHADER_STORAGE_BUFFER, sizeof initialCommands_, &initialCommands_,
                GL_DYNAMIC_COPY),
      activeVoxels_("active voxels", GL_SHADER_STORAGE_BUFFER, listBytes(initialCommands_, kind), nullptr,
                    GL_DYNAMIC_COPY) {
    if (missesCounts())
        dispatched_.emplace("dispatched commands", GL_COPY_WRITE_BUFFER, sizeof initialCommands_,
                            &initialCommands_, GL_DYNAMIC_COPY);
    if (kind == Kind::packed) sparseClear_ = gl::Program(shaders, packedClearProgram());
    clearTexture();
}

std::size_t VoxelPyramid::bytesFor(int grid, std::uint32_t baseCapacity, Kind kind, int cascades) {
    return gl::textureBytes(GL_R32UI, grid, grid, grid * cascades, levelsOf(grid, kind)) +
           listBytes(makeInitialCommands(grid, baseCapacity, kind, cascades), kind);
}

Resources VoxelPyramid::resources() const {
    Resources resources;
    add(resources, texture_);
    add(resources, activeVoxels_);
    add(resources, commands_);
    if (dispatched_) add(resources, *dispatched_);
    return resources;
}

void VoxelPyramid::clear() {
    const gl::DebugGroup group("sparse clear");
    // Shaders of the last frame wrote the lists and the commands that this dispatch reads.
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    sparseClear_.use();
    bindLists();
    for (int level = 0; level < levels(); ++level) {
        bindLevel(VCT_IMAGE_VOXELS, level, GL_WRITE_ONLY);
        dispatchOverLevel(static_cast<std::uint32_t>(level));
    }
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    setCommands(initialCommands_);
}

// Uploads from the CPU. A copy between buffers is unsafe on PowerVR Rogue, where earlier dispatches may read
// the copied values (Skia, GrGLCaps.cpp, fTransferFromBufferToBufferSupport, driver 1.13@5720833): clear()
// would find empty lists and leave the voxels of the last frame.
void VoxelPyramid::setCommands(const shared::CommandLists& commands) const {
    commands_.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof commands, &commands);
}

void VoxelPyramid::bindLevel(int unit, int level, GLenum access) const {
    gl::BindImageTexture(static_cast<GLuint>(unit), texture_.name(), level, GL_TRUE, 0, access, GL_R32UI);
}

void VoxelPyramid::bindLists() const {
    commands_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_COMMANDS);
    activeVoxels_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_ACTIVE_VOXELS);
}

void VoxelPyramid::emptyFaceList(std::uint32_t list) const {
    shared::LevelCommands commands = initialCommands_.lists[list];
    const std::size_t first = offsetof(shared::LevelCommands, faceGroupsX),
                      end = offsetof(shared::LevelCommands, firstFace);
    commands_.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(list * sizeof commands + first),
                      static_cast<GLsizeiptr>(end - first),
                      reinterpret_cast<const std::byte*>(&commands) + first);
}

void VoxelPyramid::setStaticSums(std::uint32_t faces, bool byId) const {
    const std::array<std::uint32_t, 3> words{faces, 0, byId ? 1U : 0U};
    static_assert(offsetof(shared::CommandLists, sumsById) ==
                  offsetof(shared::CommandLists, staticSums) + 2 * sizeof words[0]);
    commands_.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, offsetof(shared::CommandLists, staticSums), sizeof words,
                      words.data());
}

void VoxelPyramid::resetBlockedRays() const {
    commands_.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, offsetof(shared::CommandLists, blockedRays),
                      sizeof(std::uint32_t), &initialCommands_.blockedRays);
}

void VoxelPyramid::dispatchOverLevel(std::uint32_t level) const {
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, level);
    dispatch(level * sizeof(shared::LevelCommands) + offsetof(shared::LevelCommands, groupsX));
}

void VoxelPyramid::dispatchOverMarkedBlocks() const {
    dispatch(VCT_BRICK_LEVEL * sizeof(shared::LevelCommands) + offsetof(shared::LevelCommands, groupsX));
}

void VoxelPyramid::dispatchOverFaces(int level) const {
    dispatch(static_cast<std::size_t>(level) * sizeof(shared::LevelCommands) +
             offsetof(shared::LevelCommands, faceGroupsX));
}

void VoxelPyramid::dispatch(std::size_t offset) const {
    const auto at = static_cast<GLintptr>(offset);
    if (dispatched_) {
        gl::MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        commands_.bind(GL_COPY_READ_BUFFER);
        dispatched_->bind(GL_COPY_WRITE_BUFFER);
        gl::CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, at, at, 3 * sizeof(GLuint));
    }
    (dispatched_ ? *dispatched_ : commands_).bind(GL_DISPATCH_INDIRECT_BUFFER);
    gl::DispatchComputeIndirect(at);
}

shared::CommandLists VoxelPyramid::readCommands() const {
    shared::CommandLists commands;
    commands_.read(&commands, sizeof commands);
    return commands;
}

std::vector<std::uint32_t> VoxelPyramid::readList(int level) const {
    const shared::LevelCommands commands = readCommands().lists[level];
    std::vector<std::uint32_t> list(std::min(commands.voxelCount, commands.capacity));
    activeVoxels_.read(list.data(), list.size() * sizeof list[0], commands.firstEntry * sizeof list[0]);
    return list;
}

std::vector<std::uint32_t> VoxelPyramid::activeCounts(const shared::CommandLists& commands) const {
    std::vector<std::uint32_t> counts;
    for (int level = 0; level < levels(); ++level) {
        const shared::LevelCommands& c = commands.lists[level];
        if (c.voxelCount > c.capacity)
            throw Error("the scene has " + std::to_string(c.voxelCount) + " active voxels at " +
                        std::to_string(grid_) + "^3, but the list has a capacity of " +
                        std::to_string(c.capacity) + "; make room for " + std::to_string(c.voxelCount) +
                        " active voxels, or use a coarser grid");
        counts.push_back(c.voxelCount);
    }
    return counts;
}

}  // namespace vct
