#include "render/face_bounces.h"

#include <algorithm>

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

FaceBounces::FaceBounces(const gl::ShaderLibrary& shaders, const GatherSettings& pixels)
    : gather_(shaders, faceBounceGatherProgram(pixels)), apply_(shaders, faceBounceProgram()) {}

// Reads the list's length back, once: what is voxelized does not change.
void FaceBounces::reserveLight(const FaceVoxels& voxels) {
    if (light_.bytes() > 0) return;
    const std::size_t blocks = std::max<std::size_t>(voxels.slots().readActiveCounts()[1], 1);
    light_ = gl::Buffer("light of the voxel faces", GL_SHADER_STORAGE_BUFFER,
                        blocks * 6 * 2 * sizeof(std::uint32_t), nullptr, GL_DYNAMIC_COPY);
}

void FaceBounces::run(int count, FaceVoxels& voxels, FaceMipmapper& mipmapper) {
    if (count == 0) return;
    const gl::DebugGroup group("bounces");
    reserveLight(voxels);
    const VoxelPyramid& slots = voxels.slots();
    for (int bounce = 0; bounce < count; ++bounce) {
        slots.bindLists();
        light_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACE_LIGHT);
        voxels.sums().bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACE_SUMS);
        voxels.faces().bind(VCT_TEX_FACES);
        slots.texture().bind(VCT_TEX_VOXELS);
        gather_.use();
        slots.dispatchOverLevel(1);
        // Next: the light is read as a buffer, and the faces that were fetched are written as an image.
        gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        apply_.use();
        voxels.bindLevel(VCT_IMAGE_FACES, 0);
        slots.dispatchOverLevel(0);
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        mipmapper.run(voxels);
    }
}

}  // namespace vct
