// The scene in GL: one vertex and one index buffer, the textures, and the draw calls sorted so that programs
// change as rarely as possible.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <vector>

#include "engine/deformer.h"
#include "engine/material_programs.h"
#include "engine/placement.h"
#include "engine/resource.h"
#include "engine/volume.h"
#include "engine/voxelization.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "scene/scene_features.h"

namespace vct {

// A part of the scene: all instances, those that can move, or those that cannot.
enum class ScenePart { all, dynamicOnly, staticOnly };

class GpuScene {
  public:
    // The scene is at rest. `emitterInstances`: which of its instances emitters.h is about, or nothing. `radianceUnit`:
    // E/pi of the light, to which emission is made relative. With Voxelization::sortedAxes the triangles of
    // each instance are sorted by their axis (axis_sort.h).
    GpuScene(const gl::ShaderLibrary& shaders, const Scene& scene, const std::vector<bool>& emitterInstances,
             const Volume& volume, float radianceUnit, int uniformAlignment, Voxelization voxelization);

    // Moves what moves, for draws to come. Uploads what the instances that moved need, and nothing else.
    void setPose(const Pose& pose);
    // Whether a pose can change anything.
    bool moves() const { return !moving_.empty(); }
    // Returns where all that can move is.
    std::vector<Placement> placements() const;
    // Returns the box around `boundsWorld` and all that moves, in the present pose.
    Bounds boundsWith(const Bounds& boundsWorld) const;

    enum class Culling { none, backFaces };

    // Draws every instance, each with the program for its material features; back faces of single-sided
    // materials are skipped with Culling::backFaces. Of two surfaces in the same place the eye sees the one
    // drawn first: with Culling::backFaces that does not depend on the order of the instances.
    void draw(Culling culling, const MaterialPrograms& programs) const;
    // Draws the triangles of a part with programs that voxelize: per instance once, or once per axis that
    // occurs.
    void drawForVoxels(const MaterialPrograms& programs, ScenePart part = ScenePart::all) const;

    const SceneFeatures& features() const { return features_; }
    Resources resources() const;

  private:
    struct IndexRange {
        std::size_t first = 0;
        int count = 0;
    };
    struct Draw {
        unsigned features = 0;
        int baseColorTexture = -1;
        int emissiveTexture = -1;
        int glossTexture = -1;
        int normalTexture = -1;
        bool doubleSided = false;
        bool mirrored = false;  // the instance's determinant is negative: front faces are clockwise
        IndexRange triangles;
        std::array<IndexRange, 3> trianglesByAxis;  // of each axis, where they are sorted
        std::size_t uniformOffset = 0;
        int moving = -1;  // index into moving_, or -1: static
    };
    // What the draw of an instance that moves is made of anew in each pose.
    struct Moving {
        int node = -1;  // of the scene's animation; -1: it changes its form, and vertices are in volume space
        glm::dmat4 worldFromObject{1.0};
        std::size_t mesh = 0;           // index into movingMeshes_, or into deforming_
        std::uint32_t firstVertex = 0;  // of the mesh
        std::size_t firstIndex = 0;     // in movingIndices_: room for all of its triangles
        Bounds boundsWorld;             // of the box around the mesh, in the present pose
        std::shared_ptr<const DeformationState> form = nullptr;  // in the present pose, where it changes
    };
    // A mesh of them: what sorts its triangles, and its box.
    struct MovingMesh {
        Mesh mesh;
        std::vector<glm::dvec3> corners;  // object space
    };

    // One that changes its form.
    struct Deforming {
        std::shared_ptr<const Deformation> deformation;
        DeformationBoxes boxes;
    };

    void addDeforming(const Mesh& mesh, Draw& draw);
    void makeDeformer(const gl::ShaderLibrary& shaders, std::vector<std::uint32_t>& indices);
    void setForm(Moving& moving, DeformationState state);
    void deform(const std::vector<std::size_t>& changed) const;
    void addMoving(const Instance& instance, const Mesh& mesh, std::uint32_t firstVertex, Draw& draw,
                   std::map<int, std::size_t>& meshes);
    void place(Draw& draw);
    void sortVisibleDraws();
    void uploadGeometry(const Scene& scene, const std::vector<std::uint32_t>& indices);
    void uploadTextures(const Scene& scene);
    void bindGeometry() const;
    void bindDraw(const Draw& draw, const gl::Program*& current, const MaterialPrograms& programs) const;

    SceneFeatures features_;
    Voxelization voxelization_;
    glm::dmat4 volumeFromWorld_;
    std::vector<Draw> draws_;  // in the order of the scene's instances, by material features
    // Indices into draws_, in an order that does not depend on that of the instances.
    std::vector<std::size_t> visibleDraws_;
    std::vector<Moving> moving_;
    std::vector<MovingMesh> movingMeshes_;
    std::vector<Deforming> deforming_;
    std::optional<Deformer> deformer_;
    std::size_t vertexFloats_ = 0;  // of each vertex, in their buffer
    // What the buffers hold, where something moves: the uniforms of all draws, the triangles of those that
    // move.
    std::vector<unsigned char> uniformBytes_;
    std::vector<std::uint32_t> movingIndices_;
    std::size_t firstMovingIndex_ = 0;
    std::vector<gl::Texture> textures_;      // as Scene::textures; without storage where nothing reads them
    std::vector<gl::Texture> dataTextures_;  // likewise, of those that hold numbers and no colours
    gl::Buffer vertices_, indices_, uniforms_;
    gl::VertexArray vertexArray_;
};

}  // namespace vct
