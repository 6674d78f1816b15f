// Meshes that change their form by skins and morph targets (glTF 2.0, sections 3.7.2.2, 3.7.3 and 3.7.4), and
// their deformation on the CPU. shaders/passes/deform.comp deforms meshes in every frame by the same
// formulas.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "scene/animation.h"
#include "scene/bounds.h"

namespace vct {

// Up to four joints that a vertex follows. The sum of the weights is 1.
struct Influences {
    std::array<std::uint16_t, 4> joints{};  // indices into Deformation::joints
    std::array<float, 4> weights{1.0F, 0.0F, 0.0F, 0.0F};
};

// Displacements in object space, which are multiplied by the target's weight and added to the vertices.
struct MorphTarget {
    std::vector<glm::vec3> positions;  // one per vertex
    std::vector<glm::vec3> normals;    // one per vertex, or none
};

struct Joint {
    int node = -1;                    // index into Animation::nodes; -1: it never moves
    glm::dmat4 worldFromJoint{1.0};   // at rest
    glm::dmat4 jointFromObject{1.0};  // the inverse bind matrix
};

// The undeformed vertices in object space, and their deformation: first by the targets, then by the joints. A
// mesh with targets and without a skin has one joint, its node.
struct Deformation {
    glm::dvec3 centre{0.0};  // file position = centre + position
    std::vector<glm::vec3> positions, normals;
    std::vector<Influences> influences;  // one per vertex; empty: all vertices follow the first joint
    std::vector<MorphTarget> targets;
    std::vector<Joint> joints;   // at least one
    int morph = -1;              // index into Animation::morphWeights; -1: the weights do not change
    std::vector<float> weights;  // weights of the targets at rest

    bool moves() const;
};

// Matrices and weights of a deformation in one pose.
struct DeformationState {
    std::vector<glm::dmat4> worldFromObject;  // one per joint
    std::vector<float> weights;               // one per target
    std::uint64_t changes = 0;                // number of changes of the undeformed vertices

    bool operator==(const DeformationState& other) const {
        return worldFromObject == other.worldFromObject && weights == other.weights &&
               changes == other.changes;
    }
};
// Returns the state in `pose`, or at rest if it is null.
DeformationState stateOf(const Deformation& deformation, const Pose* pose);

struct DeformedVertex {
    glm::dvec3 positionWorld;
    glm::dvec3 normalWorld;  // unit length, or 0 if the deformation leaves no direction
};
DeformedVertex deformedVertex(const Deformation& deformation, const DeformationState& state,
                              std::size_t vertex);

// Computes boxes around the deformed vertices quickly, from the boxes of all joints and targets. They may be
// larger than necessary: a vertex lies between the positions that each of its joints alone would give it.
class DeformationBoxes {
  public:
    explicit DeformationBoxes(const Deformation& deformation);
    // `box`: around all undeformed vertices, which follow the only joint; there are no targets.
    explicit DeformationBoxes(const Bounds& box) : jointBoxes_{box} {}
    // Returns a box around all vertices, transformed from world space by `fromWorld`.
    Bounds around(const DeformationState& state, const glm::dmat4& fromWorld) const;

  private:
    std::vector<std::optional<Bounds>>
        jointBoxes_;                   // around the vertices that follow each joint, object space
    std::vector<Bounds> targetBoxes_;  // around the displacements of each target
};

// True if most joints have a negative determinant, which reverses the winding of the triangles.
bool isMirrored(const DeformationState& state);

}  // namespace vct
