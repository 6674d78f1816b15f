// A benchmark by the thesis's method (5.1.2): for each run of a configuration a new renderer, warm-up frames
// and timed frames. It advances one frame at a time, so that an app can handle events in between.
#pragma once

#include <functional>
#include <map>
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
    // The preset thesis alone, at its own grid, gives the thesis's tables. Otherwise presets are compared.
    std::vector<std::string> presets{"thesis"};
    std::optional<int> grid;  // for all presets; empty: each preset's own
    int cascades = 1;         // for all presets with directional voxels
    glm::ivec2 size{400, 400};
    int shadowMap = 512;
    int repeat = 3;
    std::string camera, light;  // texts as in `vct render`; the caller applies the light
};

// Parses "bench scene=cornell.glb preset=thesis grid=256 cascades=1 size=400x400 shadow-map=512 repeat=3
// camera=... light=...". Each word but the first may be left out; several presets are separated by commas.
// Throws vct::Error.
BenchRequest benchRequestFromText(const std::string& text);

// The folder for a measurement's files. The file `done` or `failed` is written last and atomically, so a
// program that waits for one of them finds all other files complete.
class ResultsFolder {
  public:
    // Creates the folder and removes the files of an earlier measurement. Throws vct::Error.
    explicit ResultsFolder(const std::string& path);
    // Writes `failed` if neither was written, because then the app was ended.
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
        Settings sky;  // only skyRadiance and environment are used
        gl::Capabilities capabilities;
        gl::ReadShader shaders;
        std::string backend;              // driver.backend of timings.json
        nlohmann::ordered_json selfTest;  // result of the self-test, copied into the files; null: none
        std::function<void(const std::string&)> log;
        // The context's programs. Each is linked once, and at most one in a call of advance().
        std::shared_ptr<gl::ProgramCache> programs = std::make_shared<gl::ProgramCache>();
    };
    // Writes into `folder` the report (bench.json and bench.txt, or presets.json and presets.txt) and, for
    // the first run, timings.json and its pictures. An empty `folder` writes no files. Throws vct::Error if
    // the request is not valid.
    BenchRun(Input input, std::string folder);

    // Renders the next frame or writes the next file. Returns false once everything is written. Throws
    // vct::Error.
    bool advance();

    // Takes the time that the app needed to show the last frame, for timings.json.
    void presented(double ms);

    // The result, available after the last frame.
    const BenchReport& report() const { return report_; }

    std::string progress() const;  // "2 of 15: scene 5, 256^3, 10 degrees, run 1 of 3: gi-cone-shadow"
    // The renderer of the current configuration; null before its first frame.
    const Renderer* renderer() const {
        return renderer_ && (mode_ > 0 || frame_ > 0) ? &*renderer_ : nullptr;
    }

  private:
    BenchRuns& current() { return runs_[run_ % runs_.size()]; }
    const BenchConfig& config() const { return runs_[run_ % runs_.size()].config; }
    std::size_t count() const { return runs_.size() * static_cast<std::size_t>(input_.request.repeat); }
    Settings settingsFor(const BenchConfig& config) const;
    bool linkNext();  // links one program of the run; false: all are linked
    // Uses one program of the run for the first time, in a small frame; false: all were used.
    bool useNext();
    void beginRun();
    void frame();
    void endMode();
    void endRun();
    void writeReport();

    Input input_;
    std::string folder_;
    Camera camera_;
    SceneFeatures features_;
    std::vector<BenchRuns> runs_;  // one per configuration
    std::size_t run_ = 0;          // number of the current run, below count()
    std::vector<Output> modes_;
    std::size_t mode_ = 0;
    int frame_ = 0;  // number of the current frame in its mode
    std::optional<Renderer> renderer_;
    bool isPrepared_ = false;                          // renderer_ has voxelized the static geometry
    std::optional<Renderer> small_;                    // of useNext()
    std::size_t smallFrames_ = 0;                      // that it has rendered
    bool isSmallPrepared_ = false;                     // it has its voxels; an interrupted frame loses them
    std::size_t usedRuns_ = 0;                         // runs whose programs were all used
    TimingsReport timings_;                            // timings of the current run
    std::optional<Output> lastTimed_;                  // mode of the last frame, if it was timed
    std::map<Output, std::vector<double>> presentMs_;  // of the timed frames of the current run
    BenchReport report_;
};

}  // namespace vct
