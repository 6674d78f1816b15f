// Voxelizes parts of the scene into the sums of the base level's faces, in three passes: the triangles mark
// the faces that they cover, a pass over the occupied voxels lists these faces and those of the blocks, and
// the triangles add to the sums of the listed faces.
#pragma once

#include "engine/cascades.h"
#include "engine/directional/directional_voxels.h"
#include "engine/gpu_scene.h"

namespace vct {

gl::ProgramDescription markFacesProgram(unsigned features);
gl::ProgramDescription listFacesProgram(bool emission);
gl::ProgramDescription accumulateProgram(unsigned features, bool emission);

// The viewport that the volume is projected to along an axis. A voxel is sixteen samples: two pixels wide
// with four samples each, or four pixels wide with one sample if the driver does not say which samples a
// triangle covers. The fragments write to buffers and images alone.
class FaceProjection {
  public:
    FaceProjection(int grid, int pixelSamples);

    // Sets the framebuffer and the viewport for the next draws.
    void use() const;
    // Side of the framebuffer in pixels.
    static int sideFor(int grid, int pixelSamples);

  private:
    glm::ivec4 viewport_;  // x, y, width, height
    gl::Framebuffer framebuffer_;
};

class DirectionalVoxelizer {
  public:
    DirectionalVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid, int pixelSamples,
                         bool emission);

    // The part of the cascades that is voxelized.
    struct Region {
        const Cascades& cascades;
        std::uint32_t moved = DirectionalVoxels::allCascades;  // a bit for each cascade that is voxelized
        const CascadeShifts* shifts = nullptr;                 // null: all of these cascades
    };
    // Lists the faces that a part of the scene covers, in list 0, of static geometry, or the dynamic one.
    void listFaces(const GpuScene& scene, ScenePart part, std::uint32_t list, const DirectionalVoxels& voxels,
                   const Region& region) const;
    // Adds that part to the sums of its faces. listFaces() has to come first.
    void accumulate(const GpuScene& scene, ScenePart part, std::uint32_t list,
                    const DirectionalVoxels& voxels, const Region& region) const;

  private:
    // Draws that part once for each of the region's cascades.
    void drawIntoCascades(const GpuScene& scene, const MaterialPrograms& programs, ScenePart part,
                          const Region& region) const;

    int grid_;
    MaterialPrograms markFaces_, accumulate_;
    gl::Program listFaces_;
    FaceProjection projection_;
};

}  // namespace vct
