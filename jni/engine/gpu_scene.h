// The scene's buffers and textures in GL, and its draw calls, sorted so that programs change as rarely as
// possible.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <vector>

#include "engine/deformer.h"
#include "engine/draw_region.h"
#include "engine/material_programs.h"
#include "engine/placement.h"
#include "engine/ranges.h"
#include "engine/resource.h"
#include "engine/volume.h"
#include "engine/voxelization.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "scene/scene_features.h"

namespace vct {

// Selects all objects, the dynamic ones (which may move), or the static ones.
enum class ScenePart { all, dynamicOnly, staticOnly };

class GpuScene {
  public:
    // Uploads the scene in its rest pose. `emitterInstances`: for each instance, true if it is a compact
    // emitter (emitters.h); empty if there are none. `radianceUnit`: emission is stored relative to it. With
    // Voxelization::sortedAxes the triangles of each instance are sorted by axis (axis_sort.h).
    GpuScene(const gl::ShaderLibrary& shaders, const Scene& scene, const std::vector<bool>& emitterInstances,
             const Volume& volume, float radianceUnit, int uniformAlignment, Voxelization voxelization);

    // Sets the pose for the next draws. Uploads the data of the objects that moved, and no other.
    void setPose(const Pose& pose);
    // Replaces the vertices of the deforming object of an animation node, which follows that node alone.
    void setVertices(int node, const ExternalVertices& vertices);
    // Shows or hides the dynamic object of an animation node in the next draws, and scales its
    // emission.
    void setAppearance(int node, bool isVisible, float emissionScale);
    // True if the scene has dynamic objects, or may get some.
    bool moves() const { return !moving_.empty() || instanceRoom_ > 0; }

    // Changes of the scene's contents (gpu_scene_changes.cpp). Indices are those of Scene::textures,
    // Scene::meshes and Scene::instances, or others that are not in use. Materials must have features that
    // the scene has. Meshes and instances need Scene::instanceRoom.
    void setTexture(std::size_t texture, GLuint external);
    void addMesh(std::size_t index, const Mesh& mesh);
    void removeMesh(std::size_t index);  // one that was added, and that no instance has
    // Adds a dynamic object that the node of `instance` moves.
    void addInstance(std::size_t index, const Instance& instance, const Material& material,
                     unsigned features);
    void removeInstance(std::size_t index);  // one that was added
    // Gives an instance another material. Returns true if it is dynamic: voxels of static instances have to
    // be made again.
    bool setMaterial(std::size_t instance, const Material& material, unsigned features);
    // Placements of the dynamic objects in the present pose.
    std::vector<Placement> placements() const;
    // Bounds of the visible dynamic objects in the present pose, volume space.
    Bounds movingBounds() const;
    // Bounds of `boundsWorld` and the dynamic objects in the present pose.
    Bounds boundsWith(const Bounds& boundsWorld) const;
    // Spheres around the visible dynamic objects in the present pose, at most `largest`; volume space, the
    // radius in w. Where there are more objects, neighbours share a sphere.
    std::vector<glm::vec4> movingSpheres(std::size_t largest) const;

    enum class Culling { none, backFaces };
    // Draws the instances that `region` may hold a part of, each with the program for its material features.
    // Culling::backFaces skips the back faces of single-sided materials. If two surfaces coincide, the one
    // drawn first is visible; with Culling::backFaces the order of drawing does not depend on the order of
    // the instances.
    void draw(Culling culling, const MaterialPrograms& programs, const DrawRegion& region) const;
    // Draws a part of the scene with programs that voxelize: one draw call per instance, or one per axis.
    void drawForVoxels(const MaterialPrograms& programs, const DrawRegion& region,
                       ScenePart part = ScenePart::all) const;

    const SceneFeatures& features() const { return features_; }
    Resources resources() const;

  private:
    struct IndexRange {
        std::size_t first = 0;
        int count = 0;
    };
    struct Draw {
        std::size_t instance = 0;  // index of the scene's instance
        unsigned features = 0;
        int baseColorTexture = -1;
        int emissiveTexture = -1;
        int glossTexture = -1;
        int normalTexture = -1;
        bool doubleSided = false;
        bool mirrored = false;  // the instance's determinant is negative: front faces are clockwise
        IndexRange triangles;
        std::array<IndexRange, 3> trianglesByAxis;  // by axis, with Voxelization::sortedAxes
        std::size_t uniformOffset = 0;
        int moving = -1;     // index into moving_, or -1: static
        Bounds boundsWorld;  // of a static instance
    };
    // A dynamic object in the present pose.
    struct Moving {
        int node = -1;  // animation node that moves the object; -1: the mesh deforms by other nodes
        glm::dmat4 worldFromObject{1.0};
        std::size_t mesh = 0;           // index into movingMeshes_, or into deforming_ if the mesh deforms
        std::uint32_t firstVertex = 0;  // the mesh's first vertex in the vertex buffer
        std::size_t firstIndex = 0;     // in movingIndices_, where its sorted triangles begin
        Bounds boundsWorld;
        std::shared_ptr<const DeformationState> form = nullptr;  // null if the object is rigid; else
                                                                 // the vertices are in volume space
        bool isVisible = true;
        float emissionScale = 1.0F;
        glm::vec3 emission{0.0F};   // before it is scaled, relative to the radiance unit
        std::uint64_t changes = 0;  // of material and mesh
        enum class Origin { described, added, removed } origin = Origin::described;
    };
    // The mesh of rigid dynamic objects, kept to sort its triangles in each pose.
    struct MovingMesh {
        Mesh mesh;
        std::vector<glm::dvec3> corners;  // corners of its bounds, object space
        std::uint32_t firstVertex = 0;    // in the vertex buffer
        std::size_t firstIndex = 0;       // in the index buffer, of its triangles
    };

    // A mesh that deforms (skin or morph targets).
    struct Deforming {
        std::shared_ptr<const Deformation> deformation;
        DeformationBoxes boxes;
    };

    void addDeforming(const Instance& instance, const Mesh& mesh, Draw& draw);
    void makeDeformer(const gl::ShaderLibrary& shaders, std::vector<std::uint32_t>& indices);
    void setForm(Moving& moving, DeformationState state);
    void deform(const std::vector<std::size_t>& changed) const;
    void addMoving(const Instance& instance, const Mesh& mesh, std::uint32_t firstVertex, Draw& draw,
                   std::map<int, std::size_t>& meshes);
    void place(Draw& draw);
    // True if the instance is visible and its bounds meet the region.
    bool isDrawn(const Draw& draw, const DrawRegion& region) const;
    void sortDraws();
    void sortVisibleDraws();
    void setMaterial(Draw& draw, const Material& material, unsigned features);
    void uploadUniforms(const Draw& draw) const;
    Draw& drawOf(std::size_t instance);
    // Room for `count` elements of a buffer, which grows if it has too little.
    std::size_t allocate(std::size_t count, std::size_t elementBytes, Ranges& ranges, gl::Buffer& buffer);
    struct Attribute;
    std::vector<Attribute> attributes() const;
    void append(const Mesh& mesh, std::vector<float>& vertices) const;
    // Tells the vertex array where the buffers are.
    void pointAttributes() const;
    void uploadGeometry(const Scene& scene, const std::vector<std::uint32_t>& indices);
    void uploadTextures(const Scene& scene);
    void bindGeometry() const;
    void bindDraw(const Draw& draw, const gl::Program*& current, const MaterialPrograms& programs) const;

    SceneFeatures features_;
    Voxelization voxelization_;
    glm::dmat4 volumeFromWorld_;
    std::vector<Draw> draws_;  // sorted by material features
    // Indices into draws_ in an order that does not depend on the order of the scene's instances.
    std::vector<std::size_t> visibleDraws_;
    std::vector<Moving> moving_;
    std::vector<MovingMesh> movingMeshes_;
    std::vector<Deforming> deforming_;
    std::optional<Deformer> deformer_;
    std::size_t vertexFloats_ = 0;  // floats per vertex
    // Copies of what the buffers hold, for updates: the uniforms of all draws, and the sorted triangles of
    // rigid dynamic objects, but for added ones.
    std::vector<unsigned char> uniformBytes_;
    std::vector<std::uint32_t> movingIndices_;
    std::size_t firstMovingIndex_ = 0;
    float radianceUnit_;
    std::size_t instanceRoom_;
    std::vector<std::size_t> freeUniforms_;  // offsets in uniformBytes_ for added instances
    Ranges vertexRanges_, indexRanges_;      // what the buffers have for added meshes and instances
    std::vector<gl::Texture> textures_;      // by Scene::textures; no storage unless a program reads it
    std::vector<gl::Texture> dataTextures_;  // the same for textures of numbers (gloss, normals)
    gl::Buffer vertices_, indices_, uniforms_;
    gl::VertexArray vertexArray_;
};

}  // namespace vct
