#include "render/face_bounces.h"

#include <algorithm>

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

float largestBounceShare(const Scene& scene) {
    float largest = 0.0F;
    for (const Instance& instance : scene.instances) {
        // A texture only makes it smaller.
        const glm::vec4& color = scene.materials[scene.meshes[instance.mesh].material].baseColor;
        largest = std::max({largest, color.r, color.g, color.b});
    }
    return std::min(largest, 0.95F);
}

FaceBounces::FaceBounces(const gl::ShaderLibrary& shaders, int grid, bool voxelsChange)
    : level_(patchLevel(grid)),
      place_(shaders, facePatchesProgram()),
      albedos_(shaders, faceAlbedosProgram(grid)),
      gather_(shaders, faceBounceGatherProgram(grid)),
      applyToPatches_(shaders, faceBouncePatchesProgram()),
      apply_(shaders, faceBounceProgram(grid)) {
    if (!voxelsChange) return;
    const int side = grid >> level_;
    direct_ = FaceVoxels::texture("voxel faces, direct light", side, 1);
}

// Reads the list's length back: once, where what is voxelized does not change.
void FaceBounces::reservePatches(const FaceVoxels& voxels) {
    if (places_ > 0 && !direct_) return;
    const std::uint32_t blocks = std::max(voxels.slots().readActiveCounts()[level_], 1U);
    if (blocks <= places_) return;
    places_ = direct_ ? withHeadRoom(blocks) : blocks;
    std::vector<std::uint32_t> words(VCT_PATCH_HEADER + std::size_t{places_} * 6 * VCT_PATCH_WORDS);
    words[VCT_PATCH_PLACES] = places_;
    patches_ = gl::Buffer("patches of the voxel faces", GL_SHADER_STORAGE_BUFFER,
                          words.size() * sizeof words[0], words.data(), GL_DYNAMIC_COPY);
}

void FaceBounces::restoreDirect(const FaceVoxels& voxels) const {
    copyLevel(*direct_, 0, voxels.faces(), level_);
}

void FaceBounces::copyLevel(const gl::Texture& from, int fromLevel, const gl::Texture& to,
                            int toLevel) const {
    // Shaders have written it, or have fetched what is written now. No bit names this call: drivers copy as
    // an upload, by fetching, as an image or by drawing.
    gl::MemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    gl::CopyImageSubData(from.name(), from.target(), fromLevel, 0, 0, 0, to.name(), to.target(), toLevel, 0,
                         0, 0, direct_->width(), direct_->height(), direct_->height() / FaceVoxels::blocksY);
}

void FaceBounces::run(int count, FaceVoxels& voxels, FaceMipmapper& mipmapper) {
    const gl::DebugGroup group("bounces");
    reservePatches(voxels);
    bind(voxels);
    place_.use();
    voxels.slots().dispatchOverFaces(level_);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    albedos_.use();
    voxels.slots().dispatchOverFaces(0);
    bounce(count, voxels, mipmapper);
}

void FaceBounces::runAgain(const gl::ShaderLibrary& shaders, int count, FaceVoxels& voxels,
                           FaceMipmapper& mipmapper) {
    const gl::DebugGroup group("bounces");
    if (!relight_) relight_.emplace(shaders, faceRelightPatchesProgram());
    bind(voxels);
    relight_->use();
    voxels.slots().dispatchOverFaces(level_);
    bounce(count, voxels, mipmapper);
}

void FaceBounces::bind(const FaceVoxels& voxels) const {
    voxels.bindLists();
    patches_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACE_PATCHES);
    voxels.faces().bind(VCT_TEX_FACES);
    voxels.slots().texture().bind(VCT_TEX_VOXELS);
}

void FaceBounces::bounce(int count, FaceVoxels& voxels, FaceMipmapper& mipmapper) {
    const VoxelPyramid& slots = voxels.slots();
    if (direct_) copyLevel(voxels.faces(), level_, *direct_, 0);
    for (int bounce = 1; bounce <= count; ++bounce) {
        gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        gather_.use();
        gl::Uniform1ui(VCT_UNIFORM_BOUNCE, static_cast<GLuint>(bounce));
        slots.dispatchOverFaces(level_);
        // Next: the light is read as a buffer, and the faces that were fetched are written as an image.
        gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        const bool last = bounce == count;
        const int written = last ? 0 : level_;
        (last ? apply_ : applyToPatches_).use();
        if (last) gl::Uniform1ui(VCT_UNIFORM_BOUNCE, static_cast<GLuint>(bounce));
        voxels.bindLevel(VCT_IMAGE_FACES, written);
        slots.dispatchOverFaces(written);
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        mipmapper.update(voxels, written + 1);
    }
}

}  // namespace vct
