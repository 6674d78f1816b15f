#include "engine/directional/directional_mipmapper.h"

#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

gl::ProgramDescription directionalLevelsProgram() {
    return {"directional/levels", {"directional/mipmapper.comp"}, {"VCT_LIST_PARENTS true"}};
}

gl::ProgramDescription directionalMipmapperProgram() {
    return {"directional/mipmapper", {"directional/mipmapper.comp"}, {"VCT_LIST_PARENTS false"}};
}

DirectionalMipmapper::DirectionalMipmapper(const gl::ShaderLibrary& shaders)
    : levels_(shaders, directionalLevelsProgram()), mipmap_(shaders, directionalMipmapperProgram()) {}

void DirectionalMipmapper::makeLevels(const DirectionalVoxels& voxels) {
    const gl::DebugGroup group("mipmap");
    const VoxelPyramid& index = voxels.index();
    voxels.bindLists();
    levels_.use();
    voxels.faces().bind(VCT_TEX_FACES);
    for (int level = 1; level < voxels.levels(); ++level) {
        voxels.bindLevel(VCT_IMAGE_FACES, level);
        if (level + 1 < voxels.levels()) index.bindLevel(VCT_IMAGE_VOXELS_NEXT, level + 1, GL_READ_WRITE);
        index.dispatchOverFaces(level);
        // The next level fetches the faces; its list and command are this dispatch's output.
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                          GL_COMMAND_BARRIER_BIT);
    }
    gl::MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);  // the voxel view draws the lists
}

void DirectionalMipmapper::update(const DirectionalVoxels& voxels, std::uint32_t which) {
    const gl::DebugGroup group("mipmap again");
    voxels.bindLists();
    mipmap_.use();
    gl::Uniform1ui(VCT_UNIFORM_WHICH, which);
    voxels.faces().bind(VCT_TEX_FACES);
    for (int level = 1; level < voxels.levels(); ++level) {
        voxels.bindLevel(VCT_IMAGE_FACES, level);
        voxels.index().dispatchOverFaces(level);
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
}

}  // namespace vct
