// An instance that can move, as it is placed at a moment.
#pragma once

#include <memory>

#include "scene/deformation.h"

namespace vct {

struct Placement {
    glm::dmat4 worldFromObject{1.0};
    Bounds box;                                              // around it, in volume space
    std::shared_ptr<const DeformationState> form = nullptr;  // null where it keeps its form

    bool operator==(const Placement& other) const {
        return worldFromObject == other.worldFromObject &&
               (form == other.form || (form != nullptr && other.form != nullptr && *form == *other.form));
    }
};

}  // namespace vct
