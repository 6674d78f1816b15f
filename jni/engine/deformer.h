// Applies skins and morph targets on the GPU, once per pose, and writes the vertices to the buffer that all
// passes read. It exists only if the scene has meshes that deform.
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

gl::ProgramDescription copyVerticesProgram();

// Undeformed vertices in buffers of the embedding program, three floats for each.
struct ExternalVertices {
    struct Attribute {
        GLuint buffer;
        std::size_t firstFloat, strideFloats;
    };
    Attribute positions, normals;  // object space
    Bounds box;                    // around the positions
};

class Deformer {
  public:
    // The mesh's position in the vertex and index buffers.
    struct Place {
        std::uint32_t firstVertex;
        std::size_t firstIndex;   // its triangles
        std::size_t firstSorted;  // its sorted triangles: a range of full size for each of x, y and z
    };
    struct Part {
        std::shared_ptr<const Deformation> deformation;
        std::size_t triangles;
        Place place;
    };
    // `sorts`: also sort the triangles by axis (Voxelization::sortedAxes).
    Deformer(const gl::ShaderLibrary& shaders, std::vector<Part> parts, bool sorts,
             const glm::dmat4& volumeFromWorld);

    // Replaces the undeformed vertices of `part`, between begin() and deform().
    void copyVertices(std::size_t part, const ExternalVertices& vertices);
    // Deforms `part`. A vertex has `vertexFloats` floats and begins with its position and its normal.
    void deform(std::size_t part, const DeformationState& state, const gl::Buffer& vertices,
                const gl::Buffer& indices, std::size_t vertexFloats) const;
    // Barriers: call begin() before the first deform() of a pose, and end() after the last.
    static void begin();
    static void end();

    Resources resources() const;

  private:
    void sort(const Part& part, const gl::Buffer& vertices, const gl::Buffer& indices,
              std::size_t vertexFloats) const;

    gl::Program deform_;
    gl::ShaderLibrary shaders_;
    std::optional<gl::Program> sort_, copy_;  // `copy_` is compiled on first use
    glm::dmat4 volumeFromWorld_;
    std::vector<Part> parts_;
    struct First {
        std::size_t source = 0, displacement = 0, state = 0;
    };
    std::vector<First> first_;  // by part: its position in the buffers below
    gl::Buffer sources_, displacements_, state_;
};

}  // namespace vct
