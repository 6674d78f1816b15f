#include "engine/voxel_pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/error.h"
#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

namespace {

std::vector<shared::LevelCommands> emptyCommands(int grid, int levels, std::uint32_t baseCapacity) {
    const auto cube = [grid](int level) {
        const std::uint64_t side = static_cast<std::uint64_t>(grid) >> level;
        return side * side * side;
    };
    const std::uint64_t wanted = baseCapacity != 0 ? baseCapacity : 16ULL * grid * grid;
    std::vector<shared::LevelCommands> commands(VCT_MAX_LEVELS, shared::LevelCommands{});
    std::uint32_t firstEntry = 0;
    for (int level = 0; level < levels; ++level) {
        shared::LevelCommands& c = commands[level];
        c.groupsY = c.groupsZ = c.faceGroupsY = c.faceGroupsZ = 1;
        c.firstEntry = firstEntry;
        c.capacity = static_cast<std::uint32_t>(std::min(wanted, cube(level)));
        firstEntry += c.capacity;
    }
    return commands;
}

int levelsOf(int grid) {
    return static_cast<int>(std::log2(grid)) + 1;
}

std::size_t listBytes(const std::vector<shared::LevelCommands>& commands) {
    std::size_t entries = 0;
    for (const shared::LevelCommands& c : commands)
        entries += c.capacity;
    return entries * sizeof(std::uint32_t);
}

}  // namespace

gl::ProgramDescription packedClearProgram() {
    return {"packed/clear", {"packed/clear.comp"}, {}};
}

VoxelPyramid::VoxelPyramid(const gl::ShaderLibrary& shaders, int grid, std::uint32_t baseCapacity)
    : grid_(grid),
      texture_(gl::Texture::make3d("voxels", GL_R32UI, grid, grid, grid, levelsOf(grid))),
      initialCommands_(emptyCommands(grid, texture_.levels(), baseCapacity)),
      sparseClear_(shaders, packedClearProgram()) {
    const std::size_t commandBytes = initialCommands_.size() * sizeof initialCommands_[0];
    commands_ = gl::Buffer("voxel commands", GL_SHADER_STORAGE_BUFFER, commandBytes, initialCommands_.data(),
                           GL_DYNAMIC_COPY);
    activeVoxels_ = gl::Buffer("active voxels", GL_SHADER_STORAGE_BUFFER, listBytes(initialCommands_),
                               nullptr, GL_DYNAMIC_COPY);
    gl::zeroTexture3d(texture_, grid);
}

std::size_t VoxelPyramid::bytesFor(int grid, std::uint32_t baseCapacity) {
    const int levels = levelsOf(grid);
    return gl::textureBytes(GL_R32UI, grid, grid, grid, levels) +
           listBytes(emptyCommands(grid, levels, baseCapacity));
}

Resources VoxelPyramid::resources() const {
    Resources resources;
    add(resources, texture_);
    add(resources, activeVoxels_);
    add(resources, commands_);
    return resources;
}

void VoxelPyramid::clear() {
    zero();
    emptyLists();
}

void VoxelPyramid::zero() {
    const gl::DebugGroup group("sparse clear");
    // The last frame wrote the list and the commands in shaders; they are read as buffers and commands now.
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    sparseClear_.use();
    bindLists();
    for (int level = 0; level < levels(); ++level) {
        bindLevel(VCT_IMAGE_VOXELS, level, GL_WRITE_ONLY);
        dispatchOverLevel(level);
    }
}

void VoxelPyramid::emptyLists() {
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    setCommands(initialCommands_);
}

// Not a copy of a buffer that has them: a PowerVR Rogue would let dispatches that came before read what it
// brings (Skia, GrGLCaps.cpp, fTransferFromBufferToBufferSupport, driver 1.13@5720833). The clear of this
// frame would find empty lists, and leave the voxels of the last one.
void VoxelPyramid::setCommands(const std::vector<shared::LevelCommands>& commands) {
    commands_.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(commands.size() * sizeof commands[0]),
                      commands.data());
}

void VoxelPyramid::bindLevel(int unit, int level, GLenum access) const {
    gl::BindImageTexture(static_cast<GLuint>(unit), texture_.name(), level, GL_TRUE, 0, access, GL_R32UI);
}

void VoxelPyramid::bindLists() const {
    commands_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_COMMANDS);
    activeVoxels_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_ACTIVE_VOXELS);
}

void VoxelPyramid::dispatchOverLevel(int level) const {
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
    commands_.bind(GL_DISPATCH_INDIRECT_BUFFER);
    gl::DispatchComputeIndirect(static_cast<GLintptr>(level * sizeof(shared::LevelCommands) +
                                                      offsetof(shared::LevelCommands, groupsX)));
}

void VoxelPyramid::dispatchOverFaces(int level) const {
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
    commands_.bind(GL_DISPATCH_INDIRECT_BUFFER);
    gl::DispatchComputeIndirect(static_cast<GLintptr>(level * sizeof(shared::LevelCommands) +
                                                      offsetof(shared::LevelCommands, faceGroupsX)));
}

std::size_t VoxelPyramid::placeFaceLists(std::size_t first, std::uint32_t voxels) {
    std::vector<shared::LevelCommands> current = readCommands();
    for (int level = 0; level < levels(); ++level) {
        const std::uint32_t capacity = 6 * std::min(voxels, initialCommands_[level].capacity);
        for (std::vector<shared::LevelCommands>* commands : {&current, &initialCommands_}) {
            (*commands)[level].firstFace = static_cast<std::uint32_t>(first);
            (*commands)[level].faceCapacity = capacity;
        }
        first += capacity;
    }
    setCommands(current);
    return first;
}

std::vector<shared::LevelCommands> VoxelPyramid::readCommands() const {
    std::vector<shared::LevelCommands> commands(VCT_MAX_LEVELS);
    commands_.read(commands.data(), commands.size() * sizeof commands[0]);
    commands.resize(static_cast<std::size_t>(levels()));
    return commands;
}

std::vector<std::uint32_t> VoxelPyramid::readList(int level) const {
    const shared::LevelCommands commands = readCommands()[static_cast<std::size_t>(level)];
    std::vector<std::uint32_t> list(std::min(commands.voxelCount, commands.capacity));
    activeVoxels_.read(list.data(), list.size() * sizeof list[0], commands.firstEntry * sizeof list[0]);
    return list;
}

std::vector<std::uint32_t> VoxelPyramid::activeCounts(
    const std::vector<shared::LevelCommands>& commands) const {
    std::vector<std::uint32_t> counts;
    for (const shared::LevelCommands& c : commands) {
        if (c.voxelCount > c.capacity)
            throw Error("the scene has " + std::to_string(c.voxelCount) + " active voxels at " +
                        std::to_string(grid_) + "^3, but the list holds " + std::to_string(c.capacity) +
                        "; make room for " + std::to_string(c.voxelCount) +
                        " active voxels, or use a coarser grid");
        counts.push_back(c.voxelCount);
    }
    return counts;
}

}  // namespace vct
