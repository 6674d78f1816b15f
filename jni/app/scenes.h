// Lists the scenes that can be chosen, and loads one on a thread of its own, so that the app stays
// responsive.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/baked_light.h"
#include "scene/gltf.h"

namespace vct::app {

// A scene that can be chosen.
struct SceneFile {
    std::string name;           // "cornell.glb"
    std::string path;           // path of the file, or within the APK
    bool bundled = false;       // the file is in the APK
    bool allowOutside = false;  // see GltfOptions, and the next
    double scale = 1.0;
    bool addRoomLight = true;  // light a closed room that has no light
};

struct LoadedScene {
    std::shared_ptr<const Scene> scene;
    std::vector<unsigned char> bakedLight;  // content of the file of `vct bake` beside it, or empty
};

using FindScenes = std::function<std::vector<SceneFile>()>;
// Returns a function that reads the files of a scene. It throws vct::Error once `cancelled` is true, so that
// loading ends soon.
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

    // Begins to load a scene, and cancels any loading in progress.
    void load(const SceneFile& file);
    void cancel();
    bool loading() const { return loaded_.valid(); }
    const SceneFile& loaded() const { return file_; }  // the file of the last load()

    // Returns the scene once per load(), when it is loaded, and nothing otherwise. Throws the error if
    // loading failed.
    std::optional<LoadedScene> take();

  private:
    FindScenes find_;
    ReadScene read_;
    std::vector<SceneFile> all_;
    SceneFile file_;
    std::atomic<bool> cancelled_{false};
    std::future<LoadedScene> loaded_;
};

}  // namespace vct::app
