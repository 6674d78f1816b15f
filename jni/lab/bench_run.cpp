#include "lab/bench_run.h"

#include <filesystem>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "core/files.h"
#include "engine/programs.h"
#include "gl/debug.h"
#include "image/image.h"
#include "lab/options.h"
#include "lab/program_list.h"
#include "scene/camera.h"
#include "scene/near_plane.h"

namespace vct {

namespace {

bool isThesisAlone(const BenchRequest& request) {
    return request.presets == std::vector<std::string>{"thesis"} && request.grid.value_or(256) == 256;
}

std::vector<BenchConfig> configsOf(const BenchRequest& request) {
    if (isThesisAlone(request)) return thesisConfigs();
    std::vector<BenchConfig> configs;
    for (const std::string& preset : request.presets) {
        const int grid = request.grid.value_or(presetSettings(preset).grid);
        configs.push_back(
            {preset + ", scenes 1 to 5, " + std::to_string(grid) + "^3", preset, "all", grid, 5.0});
    }
    return configs;
}

std::vector<std::string> separated(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> parts;
    for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
    return parts.empty() ? std::vector<std::string>{text} : parts;
}

// A part of the scene in the same bounds whose frames need the same programs and less time: what emits light,
// and the smallest instance of each other kind.
Scene smallPart(const Scene& scene) {
    std::map<std::tuple<unsigned, bool, bool, bool>, std::pair<double, Instance>> smallest;
    Scene part = scene;
    part.instances.clear();
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        const unsigned features = materialFeatures(material);
        if ((features & featureEmissive) != 0) {
            part.instances.push_back(instance);
            continue;
        }
        const Bounds bounds = boundsOf(cornersOf(mesh), instance.worldFromObject);
        const double extent = glm::length(bounds.max - bounds.min);
        const auto [known, isNew] = smallest.try_emplace(
            {features, material.isGlossy(), instance.moves(), instance.deforms}, extent, instance);
        if (!isNew && extent < known->second.first) known->second = {extent, instance};
    }
    for (const auto& [kind, found] : smallest)
        part.instances.push_back(found.second);
    return part;
}

}  // namespace

BenchRequest benchRequestFromText(const std::string& text) {
    const std::string command = text.substr(0, text.find(' '));
    if (command != "bench")
        throw Error("'" + text + "' begins with '" + command + "'; the one command is bench");
    BenchRequest request;
    const auto number = [](const std::string& name, const std::string& value) {
        return wholeNumberFromText("bench: " + name, value, 100000);
    };
    setFromWords(text,
                 {{"scene", [&](const auto& value) { request.scene = value; }},
                  {"preset", [&](const auto& value) { request.presets = separated(value); }},
                  {"grid", [&](const auto& value) { request.grid = number("grid", value); }},
                  {"cascades", [&](const auto& value) { request.cascades = number("cascades", value); }},
                  {"size", [&](const auto& value) { request.size = sizeFromText(value); }},
                  {"shadow-map", [&](const auto& value) { request.shadowMap = number("shadow-map", value); }},
                  {"repeat", [&](const auto& value) { request.repeat = number("repeat", value); }},
                  {"camera", [&](const auto& value) { request.camera = value; }},
                  {"light", [&](const auto& value) { request.light = value; }}});
    for (const std::string& preset : request.presets)
        presetSettings(preset);  // throws if there is no preset of that name
    return request;
}

ResultsFolder::ResultsFolder(const std::string& path) : path_(path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error)
        throw Error("cannot create the folder " + path + ": " + error.message() +
                    "; make sure that it is writable and that the device has free space");
    for (const auto& entry : std::filesystem::directory_iterator(path, error))
        if (entry.is_regular_file(error)) std::filesystem::remove(entry.path(), error);
}

ResultsFolder::~ResultsFolder() {
    try {
        if (!said_) failed("the app was ended before the measurement was");
    } catch (const Error&) {
        // The app is ending, so there is no way to report the error.
    }
}

void ResultsFolder::say(const char* name, const std::string& text) {
    if (said_) return;
    said_ = true;
    replaceFile(path_ + "/" + name, text + "\n");
}

BenchRun::BenchRun(Input input, std::string folder)
    : input_(std::move(input)),
      folder_(std::move(folder)),
      camera_(cameraFromText(input_.request.camera, *input_.scene, aspectOf(input_.request.size))) {
    const std::string note =
        cameraNote(*input_.scene, input_.request.camera, camera_, aspectOf(input_.request.size));
    if (!note.empty()) input_.log(note);
    features_ = featuresOf(*input_.scene);
    camera_ = NearPlane(*input_.scene).fitted(camera_, aspectOf(input_.request.size));
    for (const BenchConfig& config : configsOf(input_.request)) {
        validate(settingsFor(config));
        runs_.push_back({config, {}});
    }
}

Settings BenchRun::settingsFor(const BenchConfig& config) const {
    Settings settings = presetSettings(config.preset);
    settings.grid = config.grid;
    if (settings.voxels == Voxels::directional) settings.cascades = input_.request.cascades;
    settings.size = input_.request.size;
    settings.shadowMapSize = input_.request.shadowMap;
    settings.shadowConeAngleDeg = static_cast<float>(config.coneAngleDeg);
    settings.skyRadiance = input_.sky.skyRadiance;
    settings.environment = input_.sky.environment;
    settings.revoxelize = true;
    return settings;
}

std::string BenchRun::progress() const {
    std::string text = std::to_string(run_ + 1) + " of " + std::to_string(count()) + ": " + config().name +
                       ", run " + std::to_string(run_ / runs_.size() + 1) + " of " +
                       std::to_string(input_.request.repeat);
    if (renderer_ && mode_ < modes_.size()) text += std::string(": ") + outputName(modes_[mode_]);
    return text;
}

// Each configuration runs once before any runs again, so that a device that becomes warm and slow affects all
// of them.
bool BenchRun::advance() {
    try {
        if (!renderer_) {
            if (!linkNext() && !useNext()) beginRun();
        } else if (!isPrepared_) {
            renderer_->prepareVoxels(camera_);
            isPrepared_ = true;
        } else if (mode_ == modes_.size()) {
            endRun();
        } else {
            frame();
        }
    } catch (const gl::ContextLost&) {
        throw;
    } catch (const std::exception& error) {
        throw Error("bench (" + progress() + "): " + error.what());
    }
    if (run_ < count()) return true;
    writeReport();
    return false;
}

bool BenchRun::linkNext() {
    const Settings settings = settingsFor(config());
    const gl::ShaderLibrary library =
        shaderLibrary(settings, input_.capabilities, input_.shaders, input_.programs);
    for (const Output mode : modesFromText(config().modes))
        if (vct::linkNext(library, settings, mode, features_, input_.capabilities) > 0) return true;
    return false;
}

// Some drivers compile a program when it is first used. In a frame of a measurement's size that would take
// the time of a frame besides, and an interrupted frame is rendered again for each program. So these frames
// are small, and show a part of the scene, whose static geometry is voxelized in a part of its own.
bool BenchRun::useNext() {
    if (run_ < usedRuns_ || run_ >= runs_.size()) return false;
    if (!small_) {
        Settings settings = settingsFor(config());
        settings.size = glm::ivec2(24);  // not a power of two, for which llvmpipe compiles other code
        settings.grid = std::min(settings.grid, 64);
        settings.shadowMapSize = std::min(settings.shadowMapSize, 64);
        small_.emplace(smallPart(*input_.scene), input_.light, settings, input_.capabilities, input_.shaders,
                       input_.programs);
        smallFrames_ = 0;
        isSmallPrepared_ = false;
        return true;
    }
    const std::vector<Output> modes = modesFromText(config().modes);
    const std::size_t framesOfMode = warmUpFrames + 1;
    const Output mode = modes[smallFrames_ / framesOfMode];
    if (!isSmallPrepared_) {
        isSmallPrepared_ = input_.programs->runLimited([&] { small_->prepareVoxels(camera_); });
        return true;
    }
    RenderRequest request{{mode}, camera_};
    // The first frame of a mode keeps the light of the mode before, so that it has little else to do than the
    // last pass, which takes the longest to compile.
    if (smallFrames_ % framesOfMode == 0) request.lightSteps = LightSteps::none;
    isSmallPrepared_ = input_.programs->runLimited([&] { small_->render(request); });
    if (isSmallPrepared_) ++smallFrames_;
    if (smallFrames_ < modes.size() * framesOfMode) return true;
    small_.reset();
    usedRuns_ = run_ + 1;
    return false;
}

void BenchRun::beginRun() {
    input_.log("bench: " + progress());
    const Settings settings = settingsFor(config());
    renderer_.emplace(*input_.scene, input_.light, settings, input_.capabilities, input_.shaders,
                      input_.programs);
    isPrepared_ = false;
    modes_ = modesFromText(config().modes);
    mode_ = 0;
    frame_ = 0;
    timings_ = {};
    lastTimed_.reset();
    presentMs_.clear();
    timings_.scene = input_.request.scene;
    timings_.triangles = input_.scene->triangleCount();
    timings_.backend = input_.backend;
    timings_.preset = config().preset;
    timings_.settings = settings;
}

void BenchRun::frame() {
    if (frame_ == warmUpFrames) renderer_->timer().startRecording(Clocks::cpuAndGpu);
    const auto render = [&] { renderer_->render({{modes_[mode_]}, camera_}); };
    lastTimed_.reset();
    if (frame_ < warmUpFrames) {
        if (!input_.programs->runLimited(render)) return;
    } else {
        render();
        lastTimed_ = modes_[mode_];
    }
    if (++frame_ == warmUpFrames + timedFrames) endMode();
}

void BenchRun::presented(double ms) {
    if (lastTimed_) presentMs_[*lastTimed_].push_back(ms);
    lastTimed_.reset();
}

void BenchRun::endMode() {
    const Output mode = modes_[mode_];
    timings_.modes.emplace_back(mode, renderer_->timer().stopRecording());
    timings_.activeVoxels = renderer_->activeVoxels();
    if (run_ == 0 && !folder_.empty())
        writePng(folder_ + "/" + outputName(mode) + ".png", renderer_->radiance());
    ++mode_;
    frame_ = 0;
}

void BenchRun::endRun() {
    timings_.resources = renderer_->resources();
    nlohmann::ordered_json timings = timingsJson(timings_, input_.capabilities);
    if (!input_.selfTest.is_null()) timings["self_test"] = input_.selfTest;
    for (const auto& [mode, samples] : presentMs_)
        timings["modes"][outputName(mode)]["present"] =
            spreadJson("median", median(samples), "samples", samples);
    if (run_ == 0 && !folder_.empty()) writeJson(folder_ + "/timings.json", timings);
    current().timings.push_back(std::move(timings));
    renderer_.reset();
    ++run_;
}

void BenchRun::writeReport() {
    const bool thesis = isThesisAlone(input_.request);
    report_ = thesis ? thesisReport(runs_) : comparisonReport(runs_);
    if (!input_.selfTest.is_null()) report_.json["self_test"] = input_.selfTest;
    if (folder_.empty()) return;
    const std::string name = folder_ + (thesis ? "/bench" : "/presets");
    writeJson(name + ".json", report_.json);
    replaceFile(name + ".txt", report_.text);
}

}  // namespace vct
