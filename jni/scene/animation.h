// Node animation as plain data, and what it does at a time. glTF 2.0, section 3.11 and appendix C.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

namespace vct {

// How a node lies in its parent: a matrix, or translation * rotation * scale. What the file does not give is
// not multiplied in, so that a pose and a static scene are the same to the last bit.
struct NodeTransform {
    std::optional<glm::dmat4> matrix;
    std::optional<glm::dvec3> translation;
    std::optional<glm::dquat> rotation;  // of unit length
    std::optional<glm::dvec3> scale;

    glm::dmat4 parentFromNode() const;
};

// A node that an animation moves, itself or by an ancestor.
struct MovingNode {
    int parent = -1;                  // index into Animation::nodes, below this one's; -1: it does not move
    glm::dmat4 worldFromParent{1.0};  // where the parent does not move
    NodeTransform rest;               // as the file puts it
};

struct AnimationChannel {
    enum class Path { translation, rotation, scale, morphWeight };
    enum class Interpolation { step, linear, cubicSpline };

    int node = 0;    // index into Animation::nodes, or, of a weight, into Animation::morphWeights
    int target = 0;  // of a weight: which
    Path path = Path::translation;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times;  // seconds, at least one, from 0 on, strictly increasing
    // One per key, or three for cubicSpline: in-tangent, value, out-tangent. Rotations are x, y, z, w; of
    // weights x counts.
    std::vector<glm::dvec4> values;
};

// Empty (no channels) where nothing moves.
struct Animation {
    std::string name;
    std::vector<MovingNode> nodes;  // parents first
    // Of each mesh whose weights change: those of its morph targets, at rest.
    std::vector<std::vector<float>> morphWeights;
    std::vector<AnimationChannel> channels;
    double durationS = 0.0;  // the last key's time
};

// Where everything that moves is at one time: a function of the animation and the time alone.
struct Pose {
    std::vector<glm::dmat4> worldFromNode;         // of each of Animation::nodes
    std::vector<std::vector<float>> morphWeights;  // as Animation::morphWeights
};

// Before a channel's first key and after its last it stands still. `seconds` must be finite.
Pose poseAt(const Animation& animation, double seconds);

// The axes that a camera or a light has in a node: where it looks (-Z) and which way is up (+Y); scale and
// mirroring are dropped. Nothing where a scale of zero leaves no orientation.
std::optional<glm::dmat4> withoutScale(const glm::dmat4& worldFromNode);

}  // namespace vct
