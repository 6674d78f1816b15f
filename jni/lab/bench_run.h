// `vct bench` inside a program that must go on answering events: one frame at a time, a fresh renderer where
// the command line starts a fresh process.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/renderer.h"
#include "lab/bench_plan.h"
#include "lab/timings.h"

namespace vct {

struct BenchRequest {
    std::string scene;
    std::string preset = "thesis";
    // Another than 256 measures its five modes only: the thesis's tables are of 256^3 and 128^3.
    int grid = 256;
    glm::ivec2 size{400, 400};
    int shadowMap = 512;
    int repeat = 3;
    std::string camera, light;  // as for `vct render`
};

// "bench scene=cornell.glb preset=thesis grid=256 size=400x400 shadow-map=512 repeat=3 camera=... light=...",
// each but the first word may be left out; without grid it is the preset's. Throws vct::Error.
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

    std::string file(const std::string& name) const { return path_ + "/" + name; }
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
        gl::Capabilities capabilities;
        gl::ReadShader shaders;
        std::string backend;              // driver.backend of timings.json
        nlohmann::ordered_json selfTest;  // becomes part of the files
        std::function<void(const std::string&)> log;
    };
    // Throws vct::Error where the request cannot be followed.
    BenchRun(Input input, ResultsFolder& results);

    // The next frame, or the next file; false once everything is written. Throws vct::Error.
    bool advance();

    std::string progress() const;  // "2 of 15: scene 5, 256^3, 10 degrees, run 1 of 3: gi-cone-shadow"
    // Of the configuration that is being measured; null between two of them.
    const Renderer* renderer() const { return renderer_ ? &*renderer_ : nullptr; }

  private:
    const BenchConfig& config() const { return configs_[run_ % configs_.size()]; }
    void beginRun();
    void frame();
    void endMode();
    void endRun();
    void writeTables();

    Input input_;
    ResultsFolder& results_;
    Camera camera_;
    DirectionalLight light_;
    std::vector<BenchConfig> configs_;
    std::size_t run_ = 0;  // of configs_.size() * repeat
    std::vector<Mode> modes_;
    std::size_t mode_ = 0;
    int frame_ = 0;  // of this mode
    std::optional<Renderer> renderer_;
    TimingsReport report_;
    Measurements measurements_;
    nlohmann::ordered_json timings_;  // of the first run
};

}  // namespace vct
