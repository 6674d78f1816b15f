// Loads scenes on a thread of its own, so that the app goes on answering events.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/assets.h"
#include "scene/scene.h"

namespace vct::app {

class SceneLoader {
  public:
    explicit SceneLoader(AAssetManager* assets) : assets_(assets) {}
    ~SceneLoader() { cancel(); }
    SceneLoader(const SceneLoader&) = delete;
    SceneLoader& operator=(const SceneLoader&) = delete;

    // Any scene that is being loaded is given up.
    void start(const SceneFile& file);
    void cancel();
    bool busy() const { return thread_.joinable(); }

    struct Result {
        SceneFile file;
        std::shared_ptr<const Scene> scene;  // null: `error` says why
        std::string error;
    };
    // Once per start(), when it is done.
    std::optional<Result> take();

  private:
    AAssetManager* assets_;
    std::thread thread_;
    std::atomic<bool> cancelled_{false};
    std::mutex mutex_;
    std::optional<Result> result_;  // guarded by mutex_
};

}  // namespace vct::app
