// Lists files that can be chosen, and loads one on a thread of its own, so that the app stays responsive.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/log.h"

namespace vct::app {

// A file that can be chosen: a scene, or the picture of a sky.
struct FileChoice {
    std::string name;           // "cornell.glb"
    std::string path;           // path of the file, or within the APK
    bool bundled = false;       // the file is in the APK
    bool allowOutside = false;  // see GltfOptions, and the next
    double scale = 1.0;
    bool addRoomLight = true;   // light a closed room that has no light
    bool usesSkyBeside = true;  // the .hdr file of the same name beside a scene is its sky
};

using FindFiles = std::function<std::vector<FileChoice>()>;

template <class Loaded>
class FileLoader {
  public:
    // Runs on the thread. It throws vct::Error once `cancelled` is true, so that loading ends soon.
    using Load = std::function<Loaded(const FileChoice& file, const std::atomic<bool>& cancelled)>;

    FileLoader(FindFiles find, Load load) : find_(std::move(find)), load_(std::move(load)) { rescan(); }
    ~FileLoader() { cancel(); }
    FileLoader(const FileLoader&) = delete;
    FileLoader& operator=(const FileLoader&) = delete;

    const std::vector<FileChoice>& all() const { return all_; }
    void rescan() {
        all_ = find_();
        for (const FileChoice& file : added_)
            if (find(file.path) < 0) all_.push_back(file);
    }
    // Returns the index into all(), or -1.
    int find(const std::string& nameOrPath) const {
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (all_[i].name == nameOrPath || all_[i].path == nameOrPath) return static_cast<int>(i);
        return -1;
    }
    // Adds a file of any folder, unless it is listed. Returns its index into all().
    int add(const std::string& path) {
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (all_[i].path == path) return static_cast<int>(i);
        added_.push_back({path.substr(path.find_last_of('/') + 1), path});
        all_.push_back(added_.back());
        return static_cast<int>(all_.size()) - 1;
    }

    // Begins to load a file, and cancels any loading in progress.
    void load(const FileChoice& file) {
        cancel();
        log("loading " + file.path);
        file_ = file;
        loaded_ = std::async(std::launch::async, [this, file] { return load_(file, cancelled_); });
    }
    void cancel() {
        if (!loading()) return;
        cancelled_ = true;
        loaded_.wait();
        cancelled_ = false;
        loaded_ = {};
    }
    bool loading() const { return loaded_.valid(); }
    const FileChoice& loaded() const { return file_; }  // the file of the last load()

    // Returns what was loaded once per load(), and nothing before. Throws the error if loading failed.
    std::optional<Loaded> take() {
        if (!loading() || loaded_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
        return loaded_.get();
    }

  private:
    FindFiles find_;
    Load load_;
    std::vector<FileChoice> all_, added_;
    FileChoice file_;
    std::atomic<bool> cancelled_{false};
    std::future<Loaded> loaded_;
};

}  // namespace vct::app
