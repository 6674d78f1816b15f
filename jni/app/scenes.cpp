#include "app/scenes.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/log.h"
#include "scene/camera.h"
#include "scene/light_choice.h"

namespace vct::app {

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
        Scene scene = loadGltf(file.path, read_(file, cancelled_),
                               {.allowOutside = file.allowOutside, .scale = file.scale});
        const auto light = file.addRoomLight ? chooseRoomLight(scene, chooseCamera(scene, "")) : std::nullopt;
        if (light) {
            scene.punctualLights.push_back(*light);
            log(roomLightNote(*light));
        }
        return std::make_shared<const Scene>(std::move(scene));
    });
}

void Scenes::cancel() {
    if (!loading()) return;
    cancelled_ = true;
    loaded_.wait();
    cancelled_ = false;
    loaded_ = {};
}

std::shared_ptr<const Scene> Scenes::take() {
    const bool done = loading() && loaded_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    return done ? loaded_.get() : nullptr;
}

}  // namespace vct::app
