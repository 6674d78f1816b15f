#include "render/face_mipmapper.h"

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

FaceMipmapper::FaceMipmapper(const gl::ShaderLibrary& shaders)
    : levels_(shaders, faceLevelsProgram()), mipmap_(shaders, faceMipmapperProgram()) {}

void FaceMipmapper::makeLevels(const FaceVoxels& voxels) {
    const gl::DebugGroup group("mipmap");
    const VoxelPyramid& slots = voxels.slots();
    voxels.bindLists();
    levels_.use();
    voxels.faces().bind(VCT_TEX_FACES);
    for (int level = 1; level < voxels.levels(); ++level) {
        voxels.bindLevel(VCT_IMAGE_FACES, level);
        if (level + 1 < voxels.levels()) slots.bindLevel(VCT_IMAGE_VOXELS_NEXT, level + 1, GL_READ_WRITE);
        slots.dispatchOverFaces(level);
        // The next level fetches the faces; its list and command are this dispatch's output.
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                          GL_COMMAND_BARRIER_BIT);
    }
    gl::MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);  // the voxel view draws the lists
}

void FaceMipmapper::update(const FaceVoxels& voxels, std::uint32_t which) {
    const gl::DebugGroup group("mipmap again");
    voxels.bindLists();
    mipmap_.use();
    gl::Uniform1ui(VCT_UNIFORM_WHICH, which);
    voxels.faces().bind(VCT_TEX_FACES);
    for (int level = 1; level < voxels.levels(); ++level) {
        voxels.bindLevel(VCT_IMAGE_FACES, level);
        voxels.slots().dispatchOverFaces(level);
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
}

}  // namespace vct
