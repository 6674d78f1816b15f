#include "engine/packed/word_relighter.h"

#include "gl/debug.h"
#include "engine/programs.h"

namespace vct {

WordRelighter::WordRelighter(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                             Voxelization voxelization)
    : programs_(shaders, scene, [=](unsigned features) { return relightProgram(features, voxelization); }),
      mipmapper_(shaders, relightMipmapperProgram()) {}

void WordRelighter::run(const GpuScene& scene, const gl::Texture& shadowMap, PackedVoxelizer& voxelizer,
                        VoxelPyramid& voxels) {
    const gl::DebugGroup group("relight");
    voxels.zero();
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    voxelizer.draw(scene, {}, programs_, shadowMap, voxels);
}

}  // namespace vct
