// Parts of the scene into the words of the base level's faces: two passes over the triangles, with one over
// the occupied voxels between them, which lists the faces of all levels.
#pragma once

#include "engine/directional/directional_voxels.h"
#include "engine/gpu_scene.h"

namespace vct {

gl::ProgramDescription markFacesProgram(unsigned features);
gl::ProgramDescription listFacesProgram();
gl::ProgramDescription accumulateProgram(unsigned features, bool emission);

// The square that the volume is projected to, along each of its axes. It has no targets: the rasterizer only
// makes fragments.
class FaceProjection {
  public:
    explicit FaceProjection(int grid);

    // For draws to come.
    void use() const;
    // Pixels of the framebuffer's sides.
    static int sideFor(int grid);

  private:
    glm::ivec4 viewport_;  // x, y, width, height
    gl::Framebuffer framebuffer_;
};

class DirectionalVoxelizer {
  public:
    DirectionalVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid, bool emission);

    // Lists the faces that a part of the scene fills, in `list`: 0 or the voxels' dynamic list.
    void listFaces(const GpuScene& scene, ScenePart part, std::uint32_t list,
                   const DirectionalVoxels& voxels) const;
    // Adds that part to the words of its faces, which are listed.
    void accumulate(const GpuScene& scene, ScenePart part, std::uint32_t list,
                    const DirectionalVoxels& voxels) const;

  private:
    MaterialPrograms markFaces_, accumulate_;
    gl::Program listFaces_;
    FaceProjection projection_;
};

}  // namespace vct
