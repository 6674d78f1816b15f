// Loads glTF 2.0 (.gltf and .glb) into a Scene.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace vct {

// Reads a whole file. Throws vct::Error naming the file and the cause. On Android it reads an asset of the
// APK.
using ReadFile = std::function<std::vector<unsigned char>(const std::string& path)>;

std::vector<unsigned char> readFileFromDisk(const std::string& path);

struct GltfOptions {
    std::string animation = "";  // animation to play, by name or index; "": the first
    // Allows the file to refer to buffers and images outside of its folder and the folders below, after links
    // are resolved. It is off because an untrusted file could refer to any file.
    bool allowOutside = false;
    // Multiplies all lengths, for files that are not in metres. Points and spots keep the illuminance that
    // they give.
    double scale = 1.0;
};

// Throws vct::Error naming the file, the cause and the remedy.
Scene loadGltf(const std::string& path, const ReadFile& readFile = readFileFromDisk,
               const GltfOptions& options = {});

// Recomputes scene.boundsWorld from the vertices that the triangles of the instances use, at rest and in the
// poses of the animation, because the volume of the voxels must not change from frame to frame. The poses are
// those at all keys and at three times between any two, because a rotation reaches farther between its keys.
// The animation enlarges the bounds at each side by at most half of their largest side at rest: one bird that
// flies away must not make all voxels coarse. Objects outside of the volume have no voxels. Throws vct::Error
// if there is no triangle or a position is not finite.
void computeBounds(Scene& scene);

// Returns the bounds of `rest` and of all poses of what moves, where poses count only inside of `limit`.
Bounds boundsOfPoses(const Scene& scene, const Bounds& rest, const Bounds& limit);

}  // namespace vct
