// Meshes that change their form: skins and morph targets (glTF 2.0, sections 3.7.2.2, 3.7.3 and 3.7.4), and
// what a pose makes of them. Who deforms a mesh every frame does it with the same formulas on the GPU:
// shaders/passes/deform.comp.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "scene/animation.h"
#include "scene/bounds.h"

namespace vct {

// Up to four joints that a vertex follows. The weights' sum is 1.
struct Influences {
    std::array<std::uint16_t, 4> joints{};  // indices into Deformation::joints
    std::array<float, 4> weights{1.0F, 0.0F, 0.0F, 0.0F};
};

// What is added to the vertices, times the target's weight; object space.
struct MorphTarget {
    std::vector<glm::vec3> positions;  // of each vertex
    std::vector<glm::vec3> normals;    // likewise, or none
};

struct Joint {
    int node = -1;                    // index into Animation::nodes, or -1: it never moves
    glm::dmat4 worldFromJoint{1.0};   // at rest
    glm::dmat4 jointFromObject{1.0};  // the inverse bind matrix
};

// The vertices before they are deformed, in object space, and what deforms them: first the targets, then the
// joints. A mesh with targets and without a skin has one joint, its node.
struct Deformation {
    glm::dvec3 centre{0.0};  // of the positions: file position = centre + position
    std::vector<glm::vec3> positions, normals;
    std::vector<Influences> influences;  // of each vertex, or none: all follow the first joint
    std::vector<MorphTarget> targets;
    std::vector<Joint> joints;   // at least one
    int morph = -1;              // index into Animation::morphWeights, or -1: the weights do not change
    std::vector<float> weights;  // of the targets, at rest

    bool moves() const;
};

// What a pose makes of the numbers that the vertices are deformed by.
struct DeformationState {
    std::vector<glm::dmat4> worldFromObject;  // of each joint
    std::vector<float> weights;               // of each target

    bool operator==(const DeformationState& other) const {
        return worldFromObject == other.worldFromObject && weights == other.weights;
    }
};
// `pose`: null means at rest.
DeformationState stateOf(const Deformation& deformation, const Pose* pose);

struct DeformedVertex {
    glm::dvec3 positionWorld;
    glm::dvec3 normalWorld;  // of unit length, or 0 where there is no direction
};
DeformedVertex deformedVertex(const Deformation& deformation, const DeformationState& state,
                              std::size_t vertex);

// Boxes that hold the deformed vertices in every state, though they may be larger: a vertex lies between the
// places where its joints alone would put it.
class DeformationBoxes {
  public:
    explicit DeformationBoxes(const Deformation& deformation);
    // Around all vertices, in the space that `fromWorld` leads to.
    Bounds around(const DeformationState& state, const glm::dmat4& fromWorld) const;

  private:
    std::vector<std::optional<Bounds>> jointBoxes_;  // around the vertices that follow each, object space
    std::vector<Bounds> targetBoxes_;                // around the displacements
};

// A negative determinant of most joints turns the triangles' front faces around.
bool isMirrored(const DeformationState& state);

}  // namespace vct
