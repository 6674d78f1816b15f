// Animated scenes made in code.
#pragma once

#include "scene/gltf.h"
#include "support/gltf_builder.h"

namespace vct::test {

// Adds a cube of side 1 around the origin, with flat normals, as a node; `node` is glTF's, without its mesh.
int addCube(GltfBuilder& builder, const std::vector<float>& color, json node);

// A floor of 4 x 4 at y = 0, a slanting sun and a camera `front`.
GltfBuilder openFloor();

// The open floor with a box that turns and crosses a static one. The box has a mirrored child, so two
// instances move.
GltfBuilder twoThatMove();

// The open floor with a column that bends at two joints while it walks, and a box whose top swells.
GltfBuilder twoThatDeform();

// A static scene in the pose of a time, with the same volume.
Scene frozenAt(Scene scene, double seconds);

}  // namespace vct::test
