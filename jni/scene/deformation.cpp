#include "scene/deformation.h"

#include <algorithm>
#include <cmath>

namespace vct {

bool Deformation::moves() const {
    return morph >= 0 ||
           std::any_of(joints.begin(), joints.end(), [](const Joint& joint) { return joint.node >= 0; });
}

DeformationState stateOf(const Deformation& deformation, const Pose* pose) {
    DeformationState state;
    state.worldFromObject.reserve(deformation.joints.size());
    for (const Joint& joint : deformation.joints) {
        const bool moved = pose != nullptr && joint.node >= 0;
        const glm::dmat4& worldFromJoint =
            moved ? pose->worldFromNode.at(static_cast<std::size_t>(joint.node)) : joint.worldFromJoint;
        state.worldFromObject.push_back(worldFromJoint * joint.jointFromObject);
    }
    const bool morphs = pose != nullptr && deformation.morph >= 0;
    state.weights =
        morphs ? pose->morphWeights.at(static_cast<std::size_t>(deformation.morph)) : deformation.weights;
    return state;
}

DeformedVertex deformedVertex(const Deformation& deformation, const DeformationState& state,
                              std::size_t vertex) {
    glm::dvec3 position = deformation.centre + glm::dvec3(deformation.positions[vertex]);
    glm::dvec3 normal(deformation.normals[vertex]);
    for (std::size_t i = 0; i < deformation.targets.size(); ++i) {
        const double weight = state.weights[i];
        position += weight * glm::dvec3(deformation.targets[i].positions[vertex]);
        if (!deformation.targets[i].normals.empty())
            normal += weight * glm::dvec3(deformation.targets[i].normals[vertex]);
    }
    const Influences influences =
        deformation.influences.empty() ? Influences() : deformation.influences[vertex];
    glm::dmat4 worldFromObject(0.0);
    for (std::size_t i = 0; i < 4; ++i)
        if (influences.weights[i] != 0.0F)
            worldFromObject += double{influences.weights[i]} * state.worldFromObject[influences.joints[i]];
    // The cofactor matrix gives the same direction as the inverse transpose, and is finite for a scale of
    // zero.
    const glm::dmat3 m(worldFromObject);
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    normal = (glm::determinant(m) < 0.0 ? -1.0 : 1.0) * (cofactors * normal);
    const double length = glm::length(normal);
    return {glm::dvec3(worldFromObject * glm::dvec4(position, 1.0)),
            length > 0.0 && std::isfinite(length) ? normal / length : glm::dvec3(0.0)};
}

DeformationBoxes::DeformationBoxes(const Deformation& deformation) : jointBoxes_(deformation.joints.size()) {
    for (std::size_t vertex = 0; vertex < deformation.positions.size(); ++vertex) {
        const Influences influences =
            deformation.influences.empty() ? Influences() : deformation.influences[vertex];
        for (std::size_t i = 0; i < 4; ++i) {
            if (influences.weights[i] == 0.0F) continue;
            std::optional<Bounds>& box = jointBoxes_[influences.joints[i]];
            if (!box) box = noBounds;
            box->include(deformation.centre + glm::dvec3(deformation.positions[vertex]));
        }
    }
    for (const MorphTarget& target : deformation.targets) {
        Bounds box{glm::dvec3(0.0), glm::dvec3(0.0)};
        for (const glm::vec3& displacement : target.positions)
            box.include(glm::dvec3(displacement));
        targetBoxes_.push_back(box);
    }
}

Bounds DeformationBoxes::around(const DeformationState& state, const glm::dmat4& fromWorld) const {
    Bounds displaced{glm::dvec3(0.0), glm::dvec3(0.0)};
    for (std::size_t i = 0; i < targetBoxes_.size(); ++i) {
        const glm::dvec3 a = double{state.weights[i]} * targetBoxes_[i].min;
        const glm::dvec3 b = double{state.weights[i]} * targetBoxes_[i].max;
        displaced.min += glm::min(a, b);
        displaced.max += glm::max(a, b);
    }
    Bounds bounds = noBounds;
    for (std::size_t joint = 0; joint < jointBoxes_.size(); ++joint) {
        if (!jointBoxes_[joint]) continue;
        const Bounds box{jointBoxes_[joint]->min + displaced.min, jointBoxes_[joint]->max + displaced.max};
        bounds = united(bounds, boundsOf(cornersOf(box), fromWorld * state.worldFromObject[joint]));
    }
    return bounds;
}

bool isMirrored(const DeformationState& state) {
    const auto mirrored = [](const glm::dmat4& m) { return glm::determinant(glm::dmat3(m)) < 0.0; };
    const auto count = std::count_if(state.worldFromObject.begin(), state.worldFromObject.end(), mirrored);
    return 2 * static_cast<std::size_t>(count) > state.worldFromObject.size();
}

}  // namespace vct
