// Converts an embedding program's description of a scene to the engine's Scene.
#pragma once

#include <array>
#include <string>

#include "scene/scene.h"
#include "vct/vct.h"

namespace vct {

// Throws vct::Error that names the first invalid value. Instances that move get the nodes 0, 1, 2, ... in the
// order of the description. The sun is the first light.
Scene sceneOf(const SceneDescription& description);

bool hasTextures(const Material& material);
// Returns the material, whose textures get places in `textures`: that of the same texture, a free one
// (Texture::external is 0), or a new one. Throws vct::Error that begins with `name`.
Material materialOf(const MaterialDescription& description, const std::string& name,
                    std::vector<Texture>& textures);
// The mesh with the material that the description names. Throws vct::Error that begins with `name`.
Mesh meshOf(const MeshDescription& description, const Material& material, const std::string& name);
// Throws vct::Error that names the first invalid value.
DirectionalLight lightOf(const Sun& sun);
// Throws vct::Error that begins with `name` and names the first invalid value.
PunctualLight lightOf(const LightDescription& description, const std::string& name);

// Throws vct::Error with the name `what` if the matrix is not finite or not affine.
glm::dmat4 affine(const Matrix& matrix, const std::string& what);

// Returns the vector at unit length. Throws vct::Error with the name `what` if it has no direction.
glm::dvec3 direction(const std::array<double, 3>& vector, const std::string& what);

}  // namespace vct
