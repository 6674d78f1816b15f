// Voxelizes parts of the scene into the sums of the base level's faces, in three passes: the triangles mark
// the faces that they cover, a pass over the occupied voxels lists these faces and those of the blocks, and
// the triangles add to the sums of the listed faces.
#pragma once

#include "engine/cascades.h"
#include "engine/directional/directional_voxels.h"
#include "engine/gpu_scene.h"

namespace vct {

gl::ProgramDescription markFacesProgram(unsigned features);
gl::ProgramDescription listFacesProgram();
gl::ProgramDescription keepVoxelsProgram();
gl::ProgramDescription keepSumsProgram(bool emission);
gl::ProgramDescription accumulateProgram(unsigned features, bool emission);

// The viewport that the volume is projected to along an axis, four pixels per voxel. The framebuffer has no
// attachments, because the fragments write to buffers and images.
class FaceProjection {
  public:
    explicit FaceProjection(int grid);

    // Sets the framebuffer and the viewport for the next draws.
    void use() const;
    // Side of the framebuffer in pixels.
    static int sideFor(int grid);

  private:
    glm::ivec4 viewport_;  // x, y, width, height
    gl::Framebuffer framebuffer_;
};

class DirectionalVoxelizer {
  public:
    DirectionalVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid, int cascades,
                         bool emission);

    // Lists the faces that a part of the scene covers, in the static or the dynamic list. `moved`: a bit for
    // each cascade that is voxelized. The others, in a list of static geometry, keep their faces of the last
    // list.
    void listFaces(const GpuScene& scene, ScenePart part, std::uint32_t list, const DirectionalVoxels& voxels,
                   const Cascades& cascades, std::uint32_t moved = DirectionalVoxels::allCascades) const;
    // Adds that part to the sums of its faces. listFaces() has to come first.
    void accumulate(const GpuScene& scene, ScenePart part, std::uint32_t list,
                    const DirectionalVoxels& voxels, const Cascades& cascades,
                    std::uint32_t moved = DirectionalVoxels::allCascades) const;

  private:
    // Draws that part once for each of these cascades.
    void drawIntoCascades(const GpuScene& scene, const MaterialPrograms& programs, ScenePart part,
                          const Cascades& cascades, std::uint32_t moved) const;
    // True if the static list takes over faces of cascades that have not moved.
    static bool keeps(std::uint32_t list, const DirectionalVoxels& voxels, std::uint32_t moved);

    MaterialPrograms markFaces_, accumulate_;
    gl::Program listFaces_;
    gl::Program keepVoxels_, keepSums_;  // only with cascades
    FaceProjection projection_;
};

}  // namespace vct
