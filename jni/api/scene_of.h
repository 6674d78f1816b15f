// The scene of the engine from what an embedding program describes.
#pragma once

#include <array>
#include <string>

#include "scene/scene.h"
#include "vct/vct.h"

namespace vct {

// Throws vct::Error that names what is wrong. The instances that move have the nodes 0, 1, 2, ... in the
// order of the description. The sun is the first light.
Scene sceneOf(const SceneDescription& description);

// Throws vct::Error that names `what` where it is not finite, or not affine.
glm::dmat4 affine(const Matrix& matrix, const std::string& what);

// As it is given, of unit length. Throws vct::Error that names `what` where there is none.
glm::dvec3 direction(const std::array<double, 3>& vector, const std::string& what);

}  // namespace vct
