// The placement of a dynamic object in one pose, and all else that its voxels depend on.
#pragma once

#include <memory>

#include "scene/deformation.h"

namespace vct {

struct Placement {
    glm::dmat4 worldFromObject{1.0};
    Bounds box;                                              // bounds of the object, volume space
    std::shared_ptr<const DeformationState> form = nullptr;  // null if the object is rigid
    bool isVisible = true;
    float emission = 1.0F;  // scale

    bool operator==(const Placement& other) const {
        return worldFromObject == other.worldFromObject && isVisible == other.isVisible &&
               emission == other.emission &&
               (form == other.form || (form != nullptr && other.form != nullptr && *form == *other.form));
    }
};

}  // namespace vct
