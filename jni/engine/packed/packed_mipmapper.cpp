#include "engine/packed/packed_mipmapper.h"

#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

gl::ProgramDescription packedMipmapperProgram() {
    return {"packed/mipmapper", {"packed/mipmapper.comp"}, {}};
}

PackedMipmapper::PackedMipmapper(const gl::ShaderLibrary& shaders)
    : program_(shaders, packedMipmapperProgram()) {}

void PackedMipmapper::run(VoxelPyramid& voxels) {
    const gl::DebugGroup group("mipmap");
    program_.use();
    voxels.bindLists();
    for (int level = 0; level + 1 < voxels.levels(); ++level) {
        voxels.bindLevel(VCT_IMAGE_VOXELS, level, GL_READ_ONLY);
        voxels.bindLevel(VCT_IMAGE_VOXELS_NEXT, level + 1, GL_READ_WRITE);
        voxels.dispatchOverLevel(level);
        // The next dispatch reads the image, the list and the command that this one writes.
        gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                          GL_COMMAND_BARRIER_BIT);
    }
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

}  // namespace vct
