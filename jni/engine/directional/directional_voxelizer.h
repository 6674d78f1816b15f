// The scene into the base level of the directional coverage voxels, lit by the shadow map: two passes over
// the triangles, then one over what they occupied.
#pragma once

#include <functional>

#include "engine/directional/directional_voxels.h"
#include "engine/gpu_scene.h"
#include "engine/passes/punctual_lights.h"

namespace vct {

gl::ProgramDescription occupancyProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription directionalVoxelizerProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription directionalResolveProgram();

// The square that the volume is projected to, along each of its axes. It has no targets: the rasterizer only
// makes fragments.
class FaceProjection {
  public:
    explicit FaceProjection(int grid);

    // Of draws to come.
    void use() const;
    const glm::ivec4& viewport() const { return viewport_; }  // x, y, width, height
    // Pixels of the framebuffer's sides.
    static int sideFor(int grid);

  private:
    glm::ivec4 viewport_;
    gl::Framebuffer framebuffer_;
};

class DirectionalVoxelizer {
  public:
    DirectionalVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                         Voxelization voxelization);

    // Empties `voxels`, then writes its base level and the base level's list.
    void run(const GpuScene& scene, const DirectLight& light, DirectionalVoxels& voxels);

    // The passes of that. Adds to the base level's list what a part of the scene occupies.
    void markOccupied(const GpuScene& scene, const ScenePart& part, DirectionalVoxels& voxels) const;
    // Adds the part to the sums of the voxels in the list, for which there must be room. The programs: those
    // for all of it, or others of the same features.
    void accumulate(const GpuScene& scene, const ScenePart& part, const MaterialPrograms& programs,
                    const DirectLight& light, DirectionalVoxels& voxels) const;
    const MaterialPrograms& programs() const { return accumulate_; }
    // The sums into the faces and their lists, by a program for whichever voxels `dispatch` visits.
    void resolve(const gl::Program& program, DirectionalVoxels& voxels,
                 const std::function<void()>& dispatch) const;

  private:
    MaterialPrograms markOccupied_, accumulate_;
    gl::Program resolve_;
    FaceProjection projection_;
    gl::PlainSampler plainDepth_;  // the shadow map for shared/shadow.glsl
};

}  // namespace vct
