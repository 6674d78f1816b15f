// Animations as plain data, and their evaluation at a time. glTF 2.0, section 3.11 and appendix C.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

namespace vct {

// Transform from a node to its parent: a matrix, or translation * rotation * scale. Parts that the file does
// not give are not multiplied in, so that a rest pose equals a static scene to the last bit.
struct NodeTransform {
    std::optional<glm::dmat4> matrix;
    std::optional<glm::dvec3> translation;
    std::optional<glm::dquat> rotation;  // unit length
    std::optional<glm::dvec3> scale;

    glm::dmat4 parentFromNode() const;
};

// A node that an animation moves, directly or by one of its ancestors.
struct MovingNode {
    int parent = -1;  // index into Animation::nodes, less than this node's; -1: the parent does not move
    glm::dmat4 worldFromParent{1.0};  // used if the parent does not move
    NodeTransform rest;               // as in the file
};

struct AnimationChannel {
    enum class Path { translation, rotation, scale, morphWeight };
    enum class Interpolation { step, linear, cubicSpline };

    int node = 0;    // index into Animation::nodes, or into Animation::morphWeights for a weight
    int target = 0;  // index of the morph target for a weight
    Path path = Path::translation;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times;  // seconds, at least one, from 0 on, strictly increasing
    // One value per key, or three for cubicSpline: in-tangent, value, out-tangent. A rotation is x, y, z, w;
    // a weight is in x.
    std::vector<glm::dvec4> values;
};

// One animation of a scene. It has no channels if nothing moves.
struct Animation {
    std::string name;
    std::vector<MovingNode> nodes;  // parents first
    // Weights at rest of the morph targets, for each mesh whose weights change.
    std::vector<std::vector<float>> morphWeights;
    std::vector<AnimationChannel> channels;
    double durationS = 0.0;  // time of the last key
};

// Transforms and weights of everything that moves, at one time. It depends only on the animation and the
// time.
struct Pose {
    std::vector<glm::dmat4> worldFromNode;         // one per node of Animation::nodes
    std::vector<std::vector<float>> morphWeights;  // one list per element of Animation::morphWeights
};

// Evaluates the animation. A channel keeps the value of its first key before that key, and of its last key
// after it. `seconds` must be finite.
Pose poseAt(const Animation& animation, double seconds);

// Removes scale and mirroring, for a camera or a light at a node: keeps the view direction (-Z), the upward
// direction (+Y) and the position. Returns nothing if a scale of zero leaves no orientation.
std::optional<glm::dmat4> withoutScale(const glm::dmat4& worldFromNode);

}  // namespace vct
