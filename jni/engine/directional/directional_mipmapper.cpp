#include "engine/directional/directional_mipmapper.h"

#include "gl/debug.h"

namespace vct {

gl::ProgramDescription directionalMipmapperProgram() {
    return {"directional/mipmapper", {"directional/mipmapper.comp"}, {}};
}

DirectionalMipmapper::DirectionalMipmapper(const gl::ShaderLibrary& shaders)
    : program_(shaders, directionalMipmapperProgram()) {}

void DirectionalMipmapper::run(const DirectionalVoxels& voxels, std::uint32_t frameIndex) const {
    const gl::DebugGroup group("mipmap");
    voxels.bindLists();
    program_.use();
    gl::Uniform1ui(VCT_UNIFORM_FRAME_INDEX, frameIndex);
    voxels.faces().bind(VCT_TEX_FACES);
    for (int level = 1; level < voxels.levels(); ++level) {
        voxels.bindLevel(VCT_IMAGE_FACES, level);
        gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
        voxels.index().dispatchOverFaces(level);
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
}

}  // namespace vct
