// Further bounces of light: patches of the voxels' surfaces gather, and shine with what they got.
#pragma once

#include <optional>

#include "render/face_mipmapper.h"

namespace vct {

// No bounce passes on more than this share of its light: the scene's largest albedo, and at most 0.95, as a
// closed room where nothing is absorbed would have no bound.
float largestBounceShare(const Scene& scene);

class FaceBounces {
  public:
    // `grid`: of the voxels. `voxelsChange`: whether others are occupied from frame to frame.
    FaceBounces(const gl::ShaderLibrary& shaders, int grid, bool voxelsChange);

    // Adds `count` bounces, one or more, to the direct light of the faces, every level of which must be
    // there, and from two on an estimate of all that would follow.
    void run(int count, FaceVoxels& voxels, FaceMipmapper& mipmapper);
    // Likewise where only the direct light is another one than in the last run: the patches stay where they
    // are.
    void runAgain(const gl::ShaderLibrary& shaders, int count, FaceVoxels& voxels, FaceMipmapper& mipmapper);

    // Takes back what they have added to the patches' level, where others are occupied from frame to frame.
    void restoreDirect(const FaceVoxels& voxels) const;

    // shaders/shared/face_patches.glsl. Empty before the first bounce.
    const gl::Buffer& patches() const { return patches_; }
    // The patches' level of the faces before the bounces; null where nothing moves.
    const gl::Texture* direct() const { return direct_ ? &*direct_ : nullptr; }

  private:
    void reservePatches(const FaceVoxels& voxels);
    void bind(const FaceVoxels& voxels) const;
    void copyLevel(const gl::Texture& from, int fromLevel, const gl::Texture& to, int toLevel) const;
    void bounce(int count, FaceVoxels& voxels, FaceMipmapper& mipmapper);

    int level_;                 // of the patches
    std::uint32_t places_ = 0;  // of blocks in patches_
    gl::Program place_, albedos_, gather_, applyToPatches_, apply_;
    std::optional<gl::Program> relight_;  // where place_ and albedos_ have run
    gl::Buffer patches_;
    std::optional<gl::Texture> direct_;
};

}  // namespace vct
