#include "render/face_relighter.h"

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

FaceRelighter::FaceRelighter(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                             Voxelization voxelization, int samples)
    : darken_(shaders, faceDarkenProgram()),
      accumulate_(shaders, scene,
                  [=](unsigned features) { return faceRelightProgram(features, voxelization); }),
      resolve_(shaders, faceRelightResolveProgram()),
      projection_(grid, samples) {}

void FaceRelighter::run(const GpuScene& scene, const gl::Texture& shadowMap, const FaceVoxels& voxels) {
    const gl::DebugGroup group("relight");
    const VoxelPyramid& slots = voxels.slots();
    // The last bounce read the sums.
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    voxels.bindLists();
    darken_.use();
    slots.dispatchOverLevel(0);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

    projection_.use();
    shadowMap.bind(VCT_TEX_SHADOW_DEPTH);
    plainDepth_.bind(VCT_TEX_SHADOW_DEPTH);
    slots.texture().bind(VCT_TEX_VOXELS);
    scene.drawForVoxels(accumulate_);
    // The last frame fetched the faces.
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);

    resolve_.use();
    voxels.bindLevel(VCT_IMAGE_FACES, 0);
    slots.dispatchOverLevel(0);
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace vct
