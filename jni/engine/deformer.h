// Puts the vertices of meshes that change their form where a pose has them, on the GPU, once per pose, in the
// buffer from which every pass reads vertices. A scene without such meshes has none of this.
#pragma once

#include <vector>

#include "engine/resource.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace vct {

gl::ProgramDescription deformProgram();
gl::ProgramDescription sortAxesProgram();

class Deformer {
  public:
    // Where a mesh lies in the buffers of vertices and of indices.
    struct Place {
        std::uint32_t firstVertex;
        std::size_t firstIndex;   // of its triangles
        std::size_t firstSorted;  // room for three times as many: along x, then y, then z
    };
    struct Part {
        std::shared_ptr<const Deformation> deformation;
        std::size_t triangles;
        Place place;
    };
    // `sorts`: whether triangles are also sorted by their axis (Voxelization::sortedAxes).
    Deformer(const gl::ShaderLibrary& shaders, std::vector<Part> parts, bool sorts,
             const glm::dmat4& volumeFromWorld);

    // Deforms `part`. Positions and normals are the first six floats of each vertex, of `vertexFloats`.
    void deform(std::size_t part, const DeformationState& state, const gl::Buffer& vertices,
                const gl::Buffer& indices, std::size_t vertexFloats) const;
    // To be called before the first of these after draws, and behind the last, before draws.
    static void begin();
    static void end();

    Resources resources() const;

  private:
    void sort(const Part& part, const gl::Buffer& vertices, const gl::Buffer& indices,
              std::size_t vertexFloats) const;

    gl::Program deform_;
    std::optional<gl::Program> sort_;
    glm::dmat4 volumeFromWorld_;
    std::vector<Part> parts_;
    struct First {
        std::size_t source = 0, displacement = 0, state = 0;
    };
    std::vector<First> first_;  // of each part, in the buffers below
    gl::Buffer sources_, displacements_, state_;
};

}  // namespace vct
