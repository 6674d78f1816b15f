#include "scene/animation.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace vct {

namespace {

using Interpolation = AnimationChannel::Interpolation;
using Path = AnimationChannel::Path;

glm::dquat quaternion(const glm::dvec4& v) {
    return {v.w, v.x, v.y, v.z};
}

glm::dvec4 components(const glm::dquat& q) {
    return {q.x, q.y, q.z, q.w};
}

// Cubic spline of glTF's appendix C.5. `u` is in 0..1 between two keys that lie `seconds` apart.
glm::dvec4 spline(const AnimationChannel& channel, std::size_t key, double u, double seconds) {
    const glm::dvec4& value = channel.values[3 * key + 1];
    const glm::dvec4& outTangent = channel.values[3 * key + 2];
    const glm::dvec4& nextInTangent = channel.values[3 * key + 3];
    const glm::dvec4& nextValue = channel.values[3 * key + 4];
    const double u2 = u * u, u3 = u2 * u;
    return (2.0 * u3 - 3.0 * u2 + 1.0) * value + seconds * (u3 - 2.0 * u2 + u) * outTangent +
           (-2.0 * u3 + 3.0 * u2) * nextValue + seconds * (u3 - u2) * nextInTangent;
}

glm::dvec4 valueOfKey(const AnimationChannel& channel, std::size_t key) {
    return channel.values[channel.interpolation == Interpolation::cubicSpline ? 3 * key + 1 : key];
}

glm::dvec4 valueAt(const AnimationChannel& channel, double seconds) {
    const std::vector<float>& times = channel.times;
    const auto after = std::upper_bound(times.begin(), times.end(), seconds);
    if (after == times.begin()) return valueOfKey(channel, 0);
    const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end() || channel.interpolation == Interpolation::step) return valueOfKey(channel, key);

    const double length = static_cast<double>(times[key + 1]) - times[key];
    const double u = (seconds - times[key]) / length;
    if (channel.interpolation == Interpolation::cubicSpline) return spline(channel, key, u, length);
    const glm::dvec4& from = channel.values[key];
    const glm::dvec4& to = channel.values[key + 1];
    // slerp takes the shorter of the two arcs, as appendix C.4 requires.
    if (channel.path == Path::rotation) return components(glm::slerp(quaternion(from), quaternion(to), u));
    return (1.0 - u) * from + u * to;
}

void apply(const AnimationChannel& channel, const glm::dvec4& value, NodeTransform& transform) {
    switch (channel.path) {
        case Path::morphWeight:
            return;  // it does not change the node's transform
        case Path::translation:
            transform.translation = glm::dvec3(value);
            return;
        case Path::scale:
            transform.scale = glm::dvec3(value);
            return;
        case Path::rotation: {
            // A spline between opposite keys may pass through zero, which is not a rotation.
            const glm::dquat rotation = quaternion(value);
            const double length = glm::length(rotation);
            transform.rotation =
                length > 1e-6 ? rotation / length : glm::normalize(quaternion(valueOfKey(channel, 0)));
            return;
        }
    }
}

}  // namespace

glm::dmat4 NodeTransform::parentFromNode() const {
    if (matrix) return *matrix;
    glm::dmat4 result(1.0);
    if (translation) result = glm::translate(result, *translation);
    if (rotation) result *= glm::mat4_cast(*rotation);
    if (scale) result = glm::scale(result, *scale);
    return result;
}

Pose poseAt(const Animation& animation, double seconds) {
    std::vector<NodeTransform> transforms;
    transforms.reserve(animation.nodes.size());
    for (const MovingNode& node : animation.nodes)
        transforms.push_back(node.rest);
    Pose pose;
    pose.morphWeights = animation.morphWeights;
    for (const AnimationChannel& channel : animation.channels) {
        const glm::dvec4 value = valueAt(channel, seconds);
        if (channel.path == Path::morphWeight)
            pose.morphWeights[channel.node][channel.target] = static_cast<float>(value.x);
        else
            apply(channel, value, transforms[channel.node]);
    }

    pose.worldFromNode.reserve(animation.nodes.size());
    for (std::size_t i = 0; i < animation.nodes.size(); ++i) {
        const MovingNode& node = animation.nodes[i];
        const glm::dmat4& worldFromParent =
            node.parent < 0 ? node.worldFromParent : pose.worldFromNode[node.parent];
        pose.worldFromNode.push_back(worldFromParent * transforms[i].parentFromNode());
    }
    return pose;
}

std::optional<glm::dmat4> withoutScale(const glm::dmat4& worldFromNode) {
    const glm::dvec3 back(worldFromNode[2]);
    const glm::dvec3 right = glm::cross(glm::dvec3(worldFromNode[1]), back);
    const double backLength = glm::length(back);
    const double rightLength = glm::length(right);
    if (!(backLength > 0.0 && rightLength > 0.0 && std::isfinite(rightLength))) return std::nullopt;
    const glm::dvec3 z = back / backLength;
    const glm::dvec3 x = right / rightLength;
    return glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0), glm::dvec4(z, 0.0),
                      worldFromNode[3]);
}

}  // namespace vct
