// Triangles without order, for properties of any scene.
#pragma once

#include "scene/scene.h"

namespace vct::test {

// Some thousand triangles of all sizes down to 1/1000 of the scene's, many of them at nearly 45 degrees and
// some without area, with one-sided, two-sided, emitting and alpha-masked textured materials; each mesh in
// several instances: moved, turned, mirrored, flattened.
Scene triangleSoup(unsigned seed);

}  // namespace vct::test
