// The scenes and the pictures of skies that the viewer loads.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/file_loader.h"
#include "engine/baked_light.h"
#include "scene/gltf.h"

namespace vct::app {

struct LoadedScene {
    std::shared_ptr<const Scene> scene;
    std::vector<unsigned char> bakedLight = {};  // content of the file of `vct bake` beside it, or empty
    std::shared_ptr<const Environment> sky = nullptr;  // the .hdr file of the same name beside it, or null
};
using LoadedSky = std::shared_ptr<const Environment>;

using Scenes = FileLoader<LoadedScene>;
using SkyPictures = FileLoader<LoadedSky>;

constexpr const char* skyExtension = ".hdr";
// The path of the file beside another one, with the same name and this extension.
std::string pathBeside(const std::string& path, const char* extension);

// Returns a function that reads files beside `file` and the file itself. It throws vct::Error once
// `cancelled` is true.
using OpenFile = std::function<ReadFile(const FileChoice& file, const std::atomic<bool>& cancelled)>;
Scenes::Load sceneLoader(OpenFile open);
SkyPictures::Load skyLoader(OpenFile open);

}  // namespace vct::app
