#include "lab/bench_run.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "core/error.h"
#include "core/files.h"
#include "gl/debug.h"
#include "image/image.h"
#include "lab/options.h"

namespace vct {

namespace {

constexpr int tablesGrid = 256;

int wholeNumber(const std::string& key, const std::string& value) {
    char* end = nullptr;
    const long number = std::strtol(value.c_str(), &end, 10);
    if (value.empty() || *end != '\0' || number < 1 || number > 100000)
        throw Error("bench: " + key + "=" + value + " is not a whole number above 0");
    return static_cast<int>(number);
}

Settings settingsFor(const BenchRequest& request, const BenchConfig& config) {
    Settings settings = presetSettings(request.preset);
    settings.grid = config.grid;
    settings.size = request.size;
    settings.shadowMapSize = request.shadowMap;
    settings.shadowConeAngleDeg = static_cast<float>(config.coneAngleDeg);
    settings.revoxelize = true;
    return settings;
}

void writeText(const std::string& path, const std::string& text) {
    replaceFile(path, Bytes(text.begin(), text.end()));
}

}  // namespace

BenchRequest benchRequestFromText(const std::string& text) {
    std::istringstream words(text);
    std::string word;
    words >> word;
    if (word != "bench") throw Error("'" + text + "' begins with '" + word + "'; the one command is bench");
    BenchRequest request;
    std::optional<int> grid;  // over the preset's, in whichever order they stand
    while (words >> word) {
        const std::size_t equals = word.find('=');
        const std::string key = word.substr(0, equals);
        const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
        if (key == "scene")
            request.scene = value;
        else if (key == "preset")
            request.preset = value;
        else if (key == "grid")
            grid = wholeNumber(key, value);
        else if (key == "size")
            request.size = sizeFromText(value);
        else if (key == "shadow-map")
            request.shadowMap = wholeNumber(key, value);
        else if (key == "repeat")
            request.repeat = wholeNumber(key, value);
        else if (key == "camera")
            request.camera = value;
        else if (key == "light")
            request.light = value;
        else
            throw Error(
                "bench: unknown '" + word +
                "'; there are scene, preset, grid, size, shadow-map, repeat, camera and light, each as "
                "name=value");
    }
    request.grid = grid.value_or(presetSettings(request.preset).grid);
    return request;
}

ResultsFolder::ResultsFolder(const std::string& path) : path_(path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error)
        throw Error("cannot make the folder " + path + ": " + error.message() + "; free space on the device");
    for (const auto& entry : std::filesystem::directory_iterator(path, error))
        if (entry.is_regular_file(error)) std::filesystem::remove(entry.path(), error);
}

ResultsFolder::~ResultsFolder() {
    try {
        if (!said_) failed("the app was ended before the measurement was");
    } catch (const Error&) {
        // Nobody is left to be told.
    }
}

void ResultsFolder::say(const char* name, const std::string& text) {
    if (said_) return;
    said_ = true;
    writeText(file(name), text + "\n");
}

BenchRun::BenchRun(Input input, ResultsFolder& results)
    : input_(std::move(input)),
      results_(results),
      camera_(cameraFromText(input_.request.camera, *input_.scene)),
      light_(lightFromText(input_.request.light, *input_.scene)),
      configs_(benchConfigs()) {
    if (input_.request.grid != tablesGrid) {
        configs_.resize(1);
        configs_[0].grid = input_.request.grid;
        configs_[0].name = "scenes 1 to 5, " + std::to_string(input_.request.grid) + "^3, 5 degrees";
        input_.log("bench: no tables, which are of 256^3 and 128^3");
    }
    for (const BenchConfig& config : configs_)
        validate(settingsFor(input_.request, config));
}

std::string BenchRun::progress() const {
    const std::size_t count = configs_.size() * static_cast<std::size_t>(input_.request.repeat);
    std::string text = std::to_string(run_ + 1) + " of " + std::to_string(count) + ": " + config().name +
                       ", run " + std::to_string(run_ / configs_.size() + 1) + " of " +
                       std::to_string(input_.request.repeat);
    if (renderer_ && mode_ < modes_.size()) text += std::string(": ") + modeName(modes_[mode_]);
    return text;
}

// Every configuration once before any comes again: a device that gets warm and slow slows all of them.
bool BenchRun::advance() {
    try {
        if (!renderer_)
            beginRun();
        else if (mode_ == modes_.size())
            endRun();
        else
            frame();
    } catch (const gl::ContextLost&) {
        throw;
    } catch (const std::exception& error) {
        throw Error("bench (" + progress() + "): " + error.what());
    }
    if (run_ < configs_.size() * static_cast<std::size_t>(input_.request.repeat)) return true;
    writeTables();
    return false;
}

void BenchRun::beginRun() {
    input_.log("bench: " + progress());
    const Settings settings = forDriver(settingsFor(input_.request, config()), input_.capabilities);
    renderer_.emplace(*input_.scene, light_, settings, input_.capabilities, input_.shaders);
    modes_ = modesFromText(config().modes);
    mode_ = 0;
    frame_ = 0;
    report_ = {};
    report_.scene = input_.request.scene;
    report_.triangles = input_.scene->triangleCount();
    report_.backend = input_.backend;
    report_.preset = input_.request.preset;
    report_.settings = settings;
}

void BenchRun::frame() {
    if (frame_ == warmUpFrames) renderer_->timer().startRecording();
    renderer_->frame(modes_[mode_], camera_);
    if (++frame_ == warmUpFrames + timedFrames) endMode();
}

void BenchRun::endMode() {
    const Mode mode = modes_[mode_];
    report_.modes.emplace_back(mode, renderer_->timer().stopRecording());
    report_.activeVoxels = renderer_->activeVoxels();
    if (run_ == 0) writePng(results_.file(std::string(modeName(mode)) + ".png"), renderer_->radiance());
    ++mode_;
    frame_ = 0;
}

void BenchRun::endRun() {
    report_.resources = renderer_->resources();
    input_.log(timingsTable(report_.modes));
    nlohmann::ordered_json timings = timingsJson(report_, input_.capabilities);
    timings["self_test"] = input_.selfTest;
    collect(timings, config(), measurements_);
    if (run_ == 0) {
        writeJson(results_.file("timings.json"), timings);
        timings_ = std::move(timings);
    }
    renderer_.reset();
    ++run_;
}

void BenchRun::writeTables() {
    if (input_.request.grid != tablesGrid) return;
    nlohmann::ordered_json bench = benchJson(timings_, measurements_, "renderers");
    bench["self_test"] = input_.selfTest;
    writeJson(results_.file("bench.json"), bench);
    const std::string text = benchText(bench, measurements_);
    writeText(results_.file("bench.txt"), text);
    input_.log(text);
}

}  // namespace vct
