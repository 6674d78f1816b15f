#include "render/face_voxelizer.h"

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

FaceVoxelizer::FaceVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                             Voxelization voxelization, int samples)
    : touch_(shaders, scene, [=](unsigned features) { return faceTouchProgram(features, voxelization); }),
      accumulate_(shaders, scene,
                  [=](unsigned features) { return faceVoxelizerProgram(features, voxelization); }),
      resolve_(shaders, faceResolveProgram()),
      framebuffer_("face voxelizer", grid * samples, grid * samples) {}

void FaceVoxelizer::run(const GpuScene& scene, const gl::Texture& shadowMap, FaceVoxels& voxels) {
    const gl::DebugGroup group("voxelize");
    voxels.clear();
    framebuffer_.bind();
    gl::Disable(GL_DEPTH_TEST);
    gl::DepthMask(GL_FALSE);
    const VoxelPyramid& slots = voxels.slots();
    slots.bindLevel(VCT_IMAGE_VOXELS, 0, GL_READ_WRITE);
    slots.bindLists();
    scene.drawForVoxels(touch_);
    // Next: the places in the list are fetched as a texture.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);

    voxels.reserveSums(scene.moves());
    voxels.bindLists();
    shadowMap.bind(VCT_TEX_SHADOW_MAP);
    slots.texture().bind(VCT_TEX_VOXELS);
    scene.drawForVoxels(accumulate_);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);

    resolve_.use();
    voxels.bindLevel(VCT_IMAGE_FACES, 0);
    slots.dispatchOverFaces(0);
    // Next: the mipmapper fetches the faces, reads the lists and is dispatched by the commands.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace vct
