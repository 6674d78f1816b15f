// A measurement by the thesis's method (5.1.2), one frame at a time for a program that must go on answering
// events: a fresh renderer for each run of a configuration, frames to warm up, and frames that count.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/renderer.h"
#include "lab/bench_report.h"
#include "lab/timings.h"

namespace vct {

struct BenchRequest {
    std::string scene;
    // The preset thesis alone, at no other grid, gives the thesis's tables; presets are else compared.
    std::vector<std::string> presets{"thesis"};
    std::optional<int> grid;  // of every preset; where it is missing, each preset has its own
    glm::ivec2 size{400, 400};
    int shadowMap = 512;
    int repeat = 3;
    std::string camera, light;  // as for `vct render`; the light is the caller's to follow
};

// "bench scene=cornell.glb preset=thesis grid=256 size=400x400 shadow-map=512 repeat=3 camera=... light=...",
// each but the first word may be left out; several presets are separated by commas. Throws vct::Error.
BenchRequest benchRequestFromText(const std::string& text);

// Where a measurement's files go. `done` or `failed` appears last, whole: whoever waits for either finds
// everything else written.
class ResultsFolder {
  public:
    // Makes the folder, and removes what an earlier measurement left there. Throws vct::Error.
    explicit ResultsFolder(const std::string& path);
    // Says `failed` where nothing has been said yet: the app was ended.
    ~ResultsFolder();
    ResultsFolder(const ResultsFolder&) = delete;
    ResultsFolder& operator=(const ResultsFolder&) = delete;

    const std::string& path() const { return path_; }
    void done(const std::string& text) { say("done", text); }
    void failed(const std::string& text) { say("failed", text); }

  private:
    void say(const char* name, const std::string& text);
    std::string path_;
    bool said_ = false;
};

class BenchRun {
  public:
    struct Input {
        BenchRequest request;
        std::shared_ptr<const Scene> scene;
        DirectionalLight light;
        Settings sky;  // of which nothing else counts: skyRadiance, environment
        gl::Capabilities capabilities;
        gl::ReadShader shaders;
        std::string backend;              // driver.backend of timings.json
        nlohmann::ordered_json selfTest;  // becomes part of the files, where there was one
        std::function<void(const std::string&)> log;
    };
    // Into `folder` go the report, as bench.json and bench.txt or presets.json and presets.txt, and of the
    // first run timings.json and its pictures; "" writes no files. Throws vct::Error where the request cannot
    // be followed.
    BenchRun(Input input, std::string folder);

    // The next frame, or the next file; false once everything is written. Throws vct::Error.
    bool advance();

    // What was measured, after the last frame.
    const BenchReport& report() const { return report_; }

    std::string progress() const;  // "2 of 15: scene 5, 256^3, 10 degrees, run 1 of 3: gi-cone-shadow"
    // The renderer of the configuration that is being measured; null between two of them.
    const Renderer* renderer() const { return renderer_ ? &*renderer_ : nullptr; }

  private:
    BenchRuns& current() { return runs_[run_ % runs_.size()]; }
    const BenchConfig& config() const { return runs_[run_ % runs_.size()].config; }
    std::size_t count() const { return runs_.size() * static_cast<std::size_t>(input_.request.repeat); }
    Settings settingsFor(const BenchConfig& config) const;
    void beginRun();
    void frame();
    void endMode();
    void endRun();
    void writeReport();

    Input input_;
    std::string folder_;
    Camera camera_;
    std::vector<BenchRuns> runs_;  // of each configuration
    std::size_t run_ = 0;          // of count()
    std::vector<Output> modes_;
    std::size_t mode_ = 0;
    int frame_ = 0;  // of this mode
    std::optional<Renderer> renderer_;
    TimingsReport timings_;  // of this run
    BenchReport report_;
};

}  // namespace vct
