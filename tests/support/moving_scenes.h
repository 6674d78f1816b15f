// Animated scenes made in code.
#pragma once

#include "scene/gltf.h"
#include "support/gltf_builder.h"

namespace vct::test {

// Adds a cube of side 1 around the origin, with flat normals, as a node; `node` is glTF's, without its mesh.
int addCube(GltfBuilder& builder, const std::vector<float>& color, json node);

// A floor of 4 x 4 at y = 0, a sun from above and the side, a camera `front`. What is added stands on it.
GltfBuilder openFloor();

// On it a box that turns and crosses another, which stays; a mirrored child of it; light, camera. Two
// instances move.
GltfBuilder twoThatMove();

// On it a column that bends at two joints while it walks, and a box whose top swells, of which both change
// their form.
GltfBuilder twoThatDeform();

// The scene as it is at a time, without an animation: a fresh scene of that pose, in the same volume.
Scene frozenAt(Scene scene, double seconds);

}  // namespace vct::test
