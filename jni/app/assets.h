// Files of the APK (its folders `shaders/` and `scenes/`) and of the app's folder on the device.
#pragma once

#include <android/asset_manager.h>

#include <atomic>
#include <string>
#include <vector>

#include "gl/shader_source.h"
#include "scene/gltf.h"

namespace vct::app {

// From `shaders/` of the APK.
gl::ReadShader shadersFromAssets(AAssetManager* assets);

// A scene that can be chosen.
struct SceneFile {
    std::string name;      // "cornell.glb"
    std::string path;      // in the APK, or on the device
    bool bundled = false;  // in the APK
};

// The scenes of the APK, then the .glb and .gltf files in `folder`, each by name.
std::vector<SceneFile> findScenes(AAssetManager* assets, const std::string& folder);

// Reads the files of a scene. Once `cancelled` is true it throws vct::Error instead, so that loading ends
// soon.
ReadFile sceneReader(AAssetManager* assets, bool bundled, const std::atomic<bool>& cancelled);

}  // namespace vct::app
