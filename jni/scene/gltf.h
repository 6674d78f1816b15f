// glTF 2.0 (.gltf and .glb) into a Scene.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace vct {

// Reads a whole file; throws vct::Error naming the file and the cause. On Android this reads an asset.
using ReadFile = std::function<std::vector<unsigned char>(const std::string& path)>;

std::vector<unsigned char> readFileFromDisk(const std::string& path);

// Throws vct::Error with one sentence: the file, the cause, the remedy.
Scene loadGltf(const std::string& path, const ReadFile& readFile = readFileFromDisk);

// Recomputes scene.boundsWorld from the vertices that the triangles of the instances use.
// Throws where there is no triangle or a position is not finite.
void computeBounds(Scene& scene);

// Permutes the instances and the triangles of every mesh; the picture and the voxels must not depend on it.
// Vertex order inside a triangle is kept. Seed 0 changes nothing.
void shuffleTriangles(Scene& scene, unsigned seed);

}  // namespace vct
