#include "app/scene_loader.h"

namespace vct::app {

void SceneLoader::start(const SceneFile& file) {
    cancel();
    thread_ = std::thread([this, file] {
        Result result{file, nullptr, ""};
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

void SceneLoader::cancel() {
    if (!thread_.joinable()) return;
    cancelled_ = true;
    thread_.join();
    cancelled_ = false;
    result_.reset();
}

std::optional<SceneLoader::Result> SceneLoader::take() {
    std::optional<Result> result;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        result.swap(result_);
    }
    if (result) thread_.join();
    return result;
}

}  // namespace vct::app
