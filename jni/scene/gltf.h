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

struct GltfOptions {
    std::string animation = "";  // the one to play, by name or index; "" takes the first
    // Whether the file may name buffers and images outside of its folder and those below, after links are
    // resolved. A file from somebody else could name any.
    bool allowOutside = false;
};

// Throws vct::Error with one sentence: the file, the cause, the remedy.
Scene loadGltf(const std::string& path, const ReadFile& readFile = readFileFromDisk,
               const GltfOptions& options = {});

// Recomputes scene.boundsWorld from the vertices that the triangles of the instances use: at rest and in
// every pose, as the volume of the voxels must not change from frame to frame. (The poses at all keys and
// three in each interval between, as a rotation swings out.) What the animation does adds no more than half
// of the largest side of the bounds at rest to each side: one bird that flies off must not make all voxels
// coarse. What leaves the volume has no voxels there. Throws where there is no triangle or a position is not
// finite.
void computeBounds(Scene& scene);

// Permutes the instances and the triangles of every mesh; the picture and the voxels must not depend on it.
// Vertex order inside a triangle is kept. Seed 0 changes nothing.
void shuffleTriangles(Scene& scene, unsigned seed);

}  // namespace vct
