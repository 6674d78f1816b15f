// The placement of a dynamic object in one pose, and all else that its voxels depend on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "scene/deformation.h"

namespace vct {

struct Placement {
    glm::dmat4 worldFromObject{1.0};
    Bounds box;                                              // bounds of the object, volume space
    std::shared_ptr<const DeformationState> form = nullptr;  // null if the object is rigid
    bool isVisible = true;
    float emission = 1.0F;      // scale
    std::uint64_t changes = 0;  // number of changes of material and mesh

    bool operator==(const Placement& other) const {
        return worldFromObject == other.worldFromObject && isVisible == other.isVisible &&
               emission == other.emission && changes == other.changes &&
               (form == other.form || (form != nullptr && other.form != nullptr && *form == *other.form));
    }
};

// The boxes of all objects that differ between two poses, in both poses.
inline std::vector<Bounds> changedBoxes(const std::vector<Placement>& before,
                                        const std::vector<Placement>& now) {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < std::max(before.size(), now.size()); ++i) {
        if (i < before.size() && i < now.size() && before[i] == now[i]) continue;
        if (i < before.size()) boxes.push_back(before[i].box);
        if (i < now.size()) boxes.push_back(now[i].box);
    }
    return boxes;
}

}  // namespace vct
