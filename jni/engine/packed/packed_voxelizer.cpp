#include "engine/packed/packed_voxelizer.h"

#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/render_pass.h"

namespace vct {

gl::ProgramDescription packedVoxelizerProgram(unsigned features, Voxelization voxelization) {
    return voxelizing("packed/voxelizer", featureDefines(features, voxelFeatures), voxelization);
}

PackedVoxelizer::PackedVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                                 Voxelization voxelization)
    : programs_(shaders, scene,
                [=](unsigned features) { return packedVoxelizerProgram(features, voxelization); }),
      framebuffer_("voxelizer", grid, grid) {}

void PackedVoxelizer::run(const GpuScene& scene, const DirectLight& light, VoxelPyramid& voxels) {
    const gl::DebugGroup group("voxelize");
    voxels.clear();
    const gl::RenderPass pass(framebuffer_);
    light.bind();
    voxels.bindLevel(VCT_IMAGE_VOXELS, 0, GL_READ_WRITE);
    voxels.bindLists();
    scene.drawForVoxels(programs_, DrawRegion::volume());
    // The mipmapper comes next. It loads from the image, reads the list and is dispatched by the commands.
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                      GL_COMMAND_BARRIER_BIT);
}

}  // namespace vct
