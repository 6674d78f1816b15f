// The scenes that can be chosen, and the loading of one on a thread of its own, so that the app goes on
// answering events.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "app/assets.h"
#include "scene/scene.h"

namespace vct::app {

class Scenes {
  public:
    // `folder`: the app's on the device.
    Scenes(AAssetManager* assets, std::string folder);
    ~Scenes() { cancel(); }
    Scenes(const Scenes&) = delete;
    Scenes& operator=(const Scenes&) = delete;

    const std::vector<SceneFile>& all() const { return all_; }
    void rescan() { all_ = findScenes(assets_, folder_); }
    int find(const std::string& nameOrPath) const;  // index into all(), or -1

    // Any scene that is being loaded is given up.
    void load(const SceneFile& file);
    void cancel();
    bool loading() const { return loaded_.valid(); }
    const SceneFile& loaded() const { return file_; }  // the last one that was asked for

    // Once per load(), when it is done; null before. Throws what made loading fail.
    std::shared_ptr<const Scene> take();

  private:
    AAssetManager* assets_;
    std::string folder_;
    std::vector<SceneFile> all_;
    SceneFile file_;
    std::atomic<bool> cancelled_{false};
    std::future<std::shared_ptr<const Scene>> loaded_;
};

}  // namespace vct::app
