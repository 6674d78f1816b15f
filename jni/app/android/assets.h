// Files of the APK (its folders `shaders/` and `scenes/`) and of the app's folder on the device.
#pragma once

#include <android/asset_manager.h>

#include <atomic>
#include <string>
#include <vector>

#include "app/scenes.h"
#include "gl/shader_source.h"

namespace vct::app {

// From `shaders/` of the APK.
gl::ReadShader shadersFromAssets(AAssetManager* assets);

// The scenes of the APK, then the .glb and .gltf files in `folder`, each by name.
std::vector<SceneFile> findScenes(AAssetManager* assets, const std::string& folder);

// Reads the files of a scene. Once `cancelled` is true it throws vct::Error instead, so that loading ends
// soon.
ReadFile sceneReader(AAssetManager* assets, bool bundled, const std::atomic<bool>& cancelled);

}  // namespace vct::app
