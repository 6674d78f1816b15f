// The placement of a dynamic object in one pose.
#pragma once

#include <memory>

#include "scene/deformation.h"

namespace vct {

struct Placement {
    glm::dmat4 worldFromObject{1.0};
    Bounds box;                                              // bounds of the object, volume space
    std::shared_ptr<const DeformationState> form = nullptr;  // null if the object is rigid

    bool operator==(const Placement& other) const {
        return worldFromObject == other.worldFromObject &&
               (form == other.form || (form != nullptr && other.form != nullptr && *form == *other.form));
    }
};

}  // namespace vct
