#include "app/scenes.h"

#include <algorithm>
#include <utility>

#include "app/log.h"

namespace vct::app {

Scenes::Scenes(AAssetManager* assets, std::string folder) : assets_(assets), folder_(std::move(folder)) {
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
    thread_ = std::thread([this, file] {
        Result result;
        try {
            result.scene = std::make_shared<const Scene>(
                loadGltf(file.path, sceneReader(assets_, file.bundled, cancelled_)));
        } catch (const std::exception& error) {
            result.error = error.what();
        }
        const std::lock_guard<std::mutex> lock(mutex_);
        result_ = std::move(result);
    });
}

void Scenes::cancel() {
    if (!thread_.joinable()) return;
    cancelled_ = true;
    thread_.join();
    cancelled_ = false;
    result_.reset();
}

std::optional<Scenes::Result> Scenes::take() {
    std::optional<Result> result;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        result.swap(result_);
    }
    if (result) thread_.join();
    return result;
}

}  // namespace vct::app
