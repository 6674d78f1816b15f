// The scenes that can be chosen, and the loading of one on a thread of its own, so that the app goes on
// answering events.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "scene/gltf.h"

namespace vct::app {

// A scene that can be chosen.
struct SceneFile {
    std::string name;           // "cornell.glb"
    std::string path;           // in the APK, or a file's
    bool bundled = false;       // in the APK
    bool allowOutside = false;  // as GltfOptions has it
};

using FindScenes = std::function<std::vector<SceneFile>()>;
// What reads the files of a scene. Once `cancelled` is true it throws vct::Error instead, so that loading
// ends soon.
using ReadScene = std::function<ReadFile(const SceneFile& file, const std::atomic<bool>& cancelled)>;

class Scenes {
  public:
    Scenes(FindScenes find, ReadScene read);
    ~Scenes() { cancel(); }
    Scenes(const Scenes&) = delete;
    Scenes& operator=(const Scenes&) = delete;

    const std::vector<SceneFile>& all() const { return all_; }
    void rescan() { all_ = find_(); }
    int find(const std::string& nameOrPath) const;  // index into all(), or -1

    // Any scene that is being loaded is given up.
    void load(const SceneFile& file);
    void cancel();
    bool loading() const { return loaded_.valid(); }
    const SceneFile& loaded() const { return file_; }  // the last one that was asked for

    // Once per load(), when it is done; null before. Throws what made loading fail.
    std::shared_ptr<const Scene> take();

  private:
    FindScenes find_;
    ReadScene read_;
    std::vector<SceneFile> all_;
    SceneFile file_;
    std::atomic<bool> cancelled_{false};
    std::future<std::shared_ptr<const Scene>> loaded_;
};

}  // namespace vct::app
