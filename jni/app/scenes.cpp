#include "app/scenes.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/log.h"
#include "core/error.h"
#include "scene/camera.h"
#include "scene/light_choice.h"

namespace vct::app {

namespace {

// The content of the baked light beside a scene's file; empty if there is none.
std::vector<unsigned char> readBeside(const std::string& path, const ReadFile& read) {
    try {
        return read(path.substr(0, path.find_last_of('.')) + bakedLightExtension);
    } catch (const Error&) {
        return {};
    }
}

}  // namespace

Scenes::Scenes(FindScenes find, ReadScene read) : find_(std::move(find)), read_(std::move(read)) {
    rescan();
}

int Scenes::find(const std::string& nameOrPath) const {
    const auto found = std::find_if(all_.begin(), all_.end(), [&](const SceneFile& scene) {
        return scene.name == nameOrPath || scene.path == nameOrPath;
    });
    return found == all_.end() ? -1 : static_cast<int>(found - all_.begin());
}

void Scenes::load(const SceneFile& file) {
    cancel();
    log("loading " + file.path);
    file_ = file;
    loaded_ = std::async(std::launch::async, [this, file] {
        const ReadFile read = read_(file, cancelled_);
        Scene scene = loadGltf(file.path, read, {.allowOutside = file.allowOutside, .scale = file.scale});
        const auto light = file.addRoomLight ? chooseRoomLight(scene, chooseCamera(scene, "")) : std::nullopt;
        if (light) {
            scene.punctualLights.push_back(*light);
            log(roomLightNote(*light));
        }
        return LoadedScene{std::make_shared<const Scene>(std::move(scene)), readBeside(file.path, read)};
    });
}

void Scenes::cancel() {
    if (!loading()) return;
    cancelled_ = true;
    loaded_.wait();
    cancelled_ = false;
    loaded_ = {};
}

std::optional<LoadedScene> Scenes::take() {
    const bool done = loading() && loaded_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (!done) return {};
    return loaded_.get();
}

}  // namespace vct::app
