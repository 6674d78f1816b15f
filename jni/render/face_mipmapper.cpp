#include "render/face_mipmapper.h"

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

FaceMipmapper::FaceMipmapper(const gl::ShaderLibrary& shaders)
    : parents_(shaders, faceParentsProgram()), mipmap_(shaders, faceMipmapperProgram()) {}

void FaceMipmapper::makeLists(const FaceVoxels& voxels) {
    const gl::DebugGroup group("lists of the levels");
    const VoxelPyramid& slots = voxels.slots();
    voxels.bindLists();
    parents_.use();
    for (int level = 0; level + 1 < voxels.levels(); ++level) {
        slots.bindLevel(VCT_IMAGE_VOXELS_NEXT, level + 1, GL_READ_WRITE);
        slots.dispatchOverFaces(level);
        // The next level's list and command are this dispatch's output.
        gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    }
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

void FaceMipmapper::run(const FaceVoxels& voxels, int first) {
    const gl::DebugGroup group("mipmap");
    const VoxelPyramid& slots = voxels.slots();
    voxels.bindLists();
    mipmap_.use();
    voxels.faces().bind(VCT_TEX_FACES);
    for (int level = first; level < voxels.levels(); ++level) {
        voxels.bindLevel(VCT_IMAGE_FACES, level);
        slots.dispatchOverFaces(level);
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
}

}  // namespace vct
