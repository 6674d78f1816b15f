#include "engine/directional/relighter.h"

#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

gl::ProgramDescription clearRadianceProgram() {
    return {"directional/clear_radiance", {"directional/clear_radiance.comp"}, {}};
}

gl::ProgramDescription relightProgram(unsigned features, Voxelization voxelization) {
    return voxelizing("directional/voxelizer", featureDefines(features, voxelFeatures, {"VCT_RELIGHT true"}),
                      voxelization);
}

gl::ProgramDescription relightResolveProgram() {
    return {"directional/relight", {"directional/relight.comp"}, {}};
}

Relighter::Relighter(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                     Voxelization voxelization)
    : clearRadiance_(shaders, clearRadianceProgram()),
      accumulate_(shaders, scene, [=](unsigned features) { return relightProgram(features, voxelization); }),
      resolve_(shaders, relightResolveProgram()),
      projection_(grid) {}

void Relighter::run(const GpuScene& scene, const DirectLight& light, const DirectionalVoxels& voxels) {
    const gl::DebugGroup group("relight");
    const VoxelPyramid& index = voxels.index();
    // The last bounce read the sums.
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    voxels.bindLists();
    clearRadiance_.use();
    index.dispatchOverLevel(0);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

    projection_.use();
    light.sun.depth->bind(VCT_TEX_SHADOW_DEPTH);
    plainDepth_.bind(VCT_TEX_SHADOW_DEPTH);
    light.bindOthers();
    index.texture().bind(VCT_TEX_VOXELS);
    scene.drawForVoxels(accumulate_);
    // The last frame fetched the faces.
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);

    resolve_.use();
    voxels.bindLevel(VCT_IMAGE_FACES, 0);
    index.dispatchOverLevel(0);
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace vct
