// Reads files of the APK (from its folders `shaders/` and `scenes/`) and of the app's folder on the device.
#pragma once

#include <android/asset_manager.h>

#include <atomic>
#include <string>
#include <vector>

#include "app/scenes.h"
#include "gl/shader_source.h"

namespace vct::app {

// Reads shaders from `shaders/` in the APK.
gl::ReadShader shadersFromAssets(AAssetManager* assets);

// Lists the files of the APK's scenes/ and then those in `folder` that have one of the extensions, each
// sorted by name.
std::vector<FileChoice> findFiles(AAssetManager* assets, const std::string& folder,
                                  const std::vector<std::string>& extensions);

// Returns a function that reads the files of a scene. It throws vct::Error once `cancelled` is true, so that
// loading ends soon.
ReadFile sceneReader(AAssetManager* assets, bool bundled, const std::atomic<bool>& cancelled);

}  // namespace vct::app
