#include "engine/packed/packed_voxelizer.h"

#include "gl/debug.h"
#include "engine/programs.h"

namespace vct {

PackedVoxelizer::PackedVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                     Voxelization voxelization, int samples)
    : programs_(shaders, scene, [=](unsigned features) { return packedVoxelizerProgram(features, voxelization); }),
      pixels_(grid * samples),
      framebuffer_("voxelizer", pixels_, pixels_) {}

void PackedVoxelizer::run(const GpuScene& scene, const gl::Texture& shadowMap, VoxelPyramid& voxels) {
    const gl::DebugGroup group("voxelize");
    voxels.clear();
    draw(scene, {}, programs_, shadowMap, voxels);
}

void PackedVoxelizer::draw(const GpuScene& scene, const ScenePart& part, const MaterialPrograms& programs,
                     const gl::Texture& shadowMap, VoxelPyramid& voxels) {
    framebuffer_.bind();
    gl::Disable(GL_DEPTH_TEST);
    gl::DepthMask(GL_FALSE);
    shadowMap.bind(VCT_TEX_SHADOW_MAP);
    voxels.bindLevel(VCT_IMAGE_VOXELS, 0, GL_READ_WRITE);
    voxels.bindLevel(VCT_IMAGE_VOXELS_NEXT, 1, GL_READ_WRITE);  // read by the experiment second-atomic only
    voxels.bindLists();
    scene.drawForVoxels(programs, part, {0, 0, pixels_, pixels_});
    // Next: the mipmapper loads the image, reads the list and is dispatched by the commands.
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                      GL_COMMAND_BARRIER_BIT);
}

}  // namespace vct
