#include "app/viewer.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/log.h"
#include "gl/debug.h"
#include "scene/camera.h"

namespace vct::app {

namespace {

constexpr const char* firstScene = "cornell.glb";
const glm::vec3 black(0.0F), background(0.08F);

std::shared_ptr<const PreparedScene> prepared(LoadedScene loaded, double aspect, const ViewerHost& host) {
    PreparedScene result;
    const Scene& scene = *loaded.scene;
    result.look = host.defaultsFor(scene, loaded.sky, aspect);
    if (!result.look.camera && scene.cameras.empty()) {
        result.framed = chooseCamera(scene, "", aspect);
        result.framed->aspectRatio = aspect;
    }
    result.features = featuresOf(scene);
    result.nearPlane = std::make_unique<const NearPlane>(scene);
    result.obstacles = std::make_shared<const TriangleTree>(scene, TriangleTree::Contents::obstacles);
    result.loaded = std::move(loaded);
    return std::make_shared<const PreparedScene>(std::move(result));
}

}  // namespace

Viewer::Viewer(ViewerHost host, const ShowRequest& request)
    : host_(std::move(host)),
      scenes_(host_.findScenes, sceneLoader(host_.openFile)),
      skies_(host_.findSkies, skyLoader(host_.openFile)),
      choices_(request.choices),
      recordS_(request.recordS),
      animationS_(request.timeS),
      hud_(host_.pixelsPerDp),
      touch_(host_.pixelsPerDp),
      lastFrame_(std::chrono::steady_clock::now()) {
    if (!request.display) hud_.turnOff();
    if (recordS_ > 0) host_.keepScreenOn(true);
    const int first = scenes_.find(request.scene.empty() ? firstScene : request.scene);
    if (first < 0 && !request.scene.empty()) {
        const std::string why =
            "there is no scene '" + request.scene + "'; copy it into the folder " + host_.folder;
        fail(why);
        endRecording(why);
    }
    if (!scenes_.all().empty()) scenes_.load(scenes_.all()[std::max(first, 0)]);
}

Viewer::~Viewer() {
    scenes_.cancel();
    bench_.reset();
    selfTest_.reset();
    gl_.reset();
}

void Viewer::draw(glm::ivec2 window, const glm::ivec4& free) {
    if (!gl_) gl_ = std::make_unique<GlObjects>(host_.shaders);
    takeLoadedScene(window);
    followSky();
    const auto now = std::chrono::steady_clock::now();
    const double passedS = std::chrono::duration<double>(now - lastFrame_).count();
    lastFrame_ = now;
    if (choices_.play) animationS_ += passedS;
    frameMs_ = frameMs_ == 0.0 ? 1e3 * passedS : 0.8 * frameMs_ + 0.2 * 1e3 * passedS;
    if (!gl_->missing().empty()) return drawMessage(window, free);

    // The time is taken by waiting for the GPU, which works with every driver: GPU clocks are wrong on many
    // (gl/driver_faults.h), and the time between two frames is never below the display's refresh. To wait in
    // each frame would leave the GPU idle while the next frame is prepared.
    const bool waitsForGpu = recordS_ > 0 || (scaleFollowsTime(choices_) && scale_.wantsTime());
    if (waitsForGpu) gl::Finish();
    const auto start = std::chrono::steady_clock::now();

    testDriver();
    const bool measuring = request_ && !isLoading() && testResult_;
    bool isRendered = false;
    if (measuring)
        measure();
    else if (testResult_ || !(request_ || host_.testsDriverFirst))
        isRendered = drawScene(window);
    const Renderer* const renderer = bench_      ? bench_->renderer()
                                     : measuring ? nullptr
                                                 : gl_->rendererOf(scene_);
    present(renderer, window, free, passedS);
    if (!isRendered || !testResult_ || !waitsForGpu) return;
    gl::Finish();
    const std::chrono::duration<double, std::milli> work = std::chrono::steady_clock::now() - start;
    if (recordS_ > 0) record(1e3 * passedS, work.count());
    if (scaleFollowsTime(choices_)) {
        followTime(window, work.count());
        followHeat(window);
    }
}

// The panel belongs to the time of presenting: waiting for the GPU between picture and panel would make a GPU
// with tiles write the window to memory and read it again.
void Viewer::present(const Renderer* renderer, glm::ivec2 window, const glm::ivec4& free, double passedS) {
    const bool isTimed = renderer != nullptr && (stepMs_ || bench_);
    const double startMs = isTimed ? StepTimer::finishedAtMs() : 0.0;
    if (renderer != nullptr)
        gl_->presenter().prepare(*renderer, exposure(), window);
    else if (testResult_)
        gl_->presenter().useNext();
    {
        const gl::RenderPass pass = windowPass(window, renderer != nullptr ? black : background);
        if (renderer != nullptr) gl_->presenter().draw(window);
        drawHud(window, free, passedS);
    }
    if (!isTimed) return;
    presentMs_ = StepTimer::finishedAtMs() - startMs;
    if (bench_) bench_->presented(presentMs_);
}

// Draws the message of a driver that lacks something the renderer needs.
void Viewer::drawMessage(glm::ivec2 window, const glm::ivec4& free) {
    if (request_) endMeasuring(gl_->missing());
    const gl::RenderPass pass = windowPass(window, background);
    hud_.buildMessage("This device cannot run voxel cone tracing.", gl_->missing(), window, free);
    gl_->hud().draw(hud_.drawData(), window);
    gl::checkErrors("message");
}

void Viewer::drawHud(glm::ivec2 window, const glm::ivec4& free, double passedS) {
    const Gesture gesture = touch_.take();
    if (view_) view_->apply(gesture, window);

    HudContent content;
    content.choices = &choices_;
    int scene = scenes_.find(scenePath());
    const int sceneBefore = scene;
    content.scene = &scene;
    content.scenes = &scenes_.all();
    content.skies = &skies_.all();
    content.opensFiles = static_cast<bool>(host_.askForFile);
    content.camera = camera_;
    content.sceneLightDeg = lightAnglesDeg(defaults_.light);
    content.frameMs = frameMs_;
    content.stepMs = stepMs_ ? &*stepMs_ : nullptr;
    content.presentMs = presentMs_;
    content.renderSize = sizeIn(window);
    if (scaleFollowsTime(choices_)) content.divisor = scale_.divisor();
    content.isLimitedByHeat = scale_.isLimitedByHeat();
    content.possibleGrids = [&] {
        return gl_->possibleGrids(settingsFor(choices_, window, scale_.divisor()));
    };
    content.cascades = settingsOf(window).cascades;
    content.animated = scene_ && !scene_->animation.channels.empty();
    if (scene_) {
        for (const PunctualLight& light : scene_->punctualLights)
            content.lights.push_back(light.name);
        for (const Camera& camera : scene_->cameras)
            content.cameras.push_back(camera.name);
    }
    content.measuring = request_.has_value();
    if (scenes_.loading())
        content.status = "loading " + scenes_.loaded().name;
    else if (preparing_.valid())
        content.status = "preparing " + scenes_.loaded().name;
    else if (skies_.loading())
        content.status = "loading " + skies_.loaded().name;
    else if (unlinked_ > 1)
        content.status = "preparing the scene: " + std::to_string(unlinked_) + " programs to compile";
    else if (unlinked_ == 1)
        content.status = "preparing the scene: computing its first light";
    else if (!testResult_)
        content.status = "testing the driver" + (selfTest_ ? ": " + selfTest_->progress() : "");
    else if (bench_)
        content.status = "measuring " + bench_->progress();
    content.message = message_;
    const HudActions actions = hud_.build(content, window, free, passedS);
    gl_->hud().draw(hud_.drawData(), window);
    gl::checkErrors("panel");

    if (scene != sceneBefore) choose(scene);
    if (actions.rescan) {
        scenes_.rescan();
        skies_.rescan();
    }
    if (actions.openFile) host_.askForFile();
    if (actions.camera) showFrom(*actions.camera);
    if (actions.resetView) reset();
    if (actions.dismiss) message_.clear();
    if (actions.measure && request_)
        endMeasuring("stopped by the user");
    else if (actions.measure)
        startMeasuring("bench preset=" + choices_.preset);
}

bool Viewer::drawScene(glm::ivec2 window) {
    const Wanted wanted{choices_, scene_, window};
    unlinked_ = 0;
    if (!scene_ || (failed_ && *failed_ == wanted)) return false;
    const bool mayNeedPrograms = !good_ || *good_ != wanted || gl_->renderer() == nullptr;
    const std::string failure = failureOf([&] {
        const Settings settings = settingsOf(window);
        if (mayNeedPrograms) unlinked_ = gl_->linkNext(prepared_->features, settings, choices_.mode);
        if (unlinked_ > 0) return;
        aspect_ = aspectOf(settings.size);
        Renderer& renderer =
            gl_->rendererFor(scene_, light(), settings, choices_, prepared_->loaded.bakedLight);
        std::optional<Pose> pose;
        if (!scene_->animation.channels.empty()) {
            pose = poseAt(scene_->animation, sceneTimeS());
            renderer.setPose(*pose);
            renderer.setLightDirection(posed(light(), *pose).directionToLight);
            const Camera* const first = defaults_.camera          ? &*defaults_.camera
                                        : scene_->cameras.empty() ? nullptr
                                                                  : &scene_->cameras.front();
            if (first != nullptr && first->node >= 0) view_->follow(posed(*first, *pose));
        }
        if (choices_.timeSteps) renderer.timer().startRecording(Clocks::cpu);
        renderer.render(
            {{choices_.mode},
             prepared_->nearPlane->fitted(view_->camera(aspect_), aspect_, pose ? &*pose : nullptr)});
        if (!defaults_.exposure) exposure_.follow(renderer);
        stepMs_.reset();
        if (choices_.timeSteps) {
            const StepTimes times = renderer.timer().stopRecording();
            stepMs_.emplace();
            for (std::size_t i = 0; i < stepCount; ++i)
                (*stepMs_)[i] = times.stepMs[i].back();
        }
    });
    if (!failure.empty()) {
        revert(failure, window);
        return false;
    }
    if (unlinked_ > 0) return false;
    if (!good_ || good_->scene != scene_)
        log(scene_->path + ": " + std::to_string(scene_->triangleCount()) + " triangles");
    good_ = wanted;
    goodPrepared_ = prepared_;
    goodDefaults_ = defaults_;
    failed_.reset();
    return true;
}

glm::ivec2 Viewer::sizeIn(glm::ivec2 window) const {
    return settingsFor(choices_, window, scale_.divisor()).size;
}

// Adapts the resolution to the time of a frame, from its start until the GPU has finished it.
void Viewer::followTime(glm::ivec2 window, double workMs) {
    if (scale_.follow(workMs)) logSize("time", window);
}

void Viewer::followHeat(glm::ivec2 window) {
    if (lastFrame_ < nextHeatCheck_) return;
    nextHeatCheck_ = lastFrame_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                      std::chrono::duration<double>(ResolutionScale::heatPeriodS));
    headroom_ = host_.thermalHeadroom();
    if (headroom_ && scale_.followHeat(*headroom_)) logSize("heat", window);
}

// The first frame of the scene begins the recording; its own time includes loading.
void Viewer::record(double frameMs, double workMs) {
    try {
        if (!recording_)
            recording_.emplace(host_.folder, recordS_);
        else if (!recording_->add({frameMs, workMs, scale_.divisor(), headroom_}))
            endRecording("");
    } catch (const Error& error) {
        endRecording(error.what());
    }
}

void Viewer::endRecording(const std::string& failure) {
    if (recordS_ == 0) return;
    if (!failure.empty()) fail("recording failed: " + failure);
    try {
        if (recording_ && !failure.empty()) recording_->failed(failure);
    } catch (const Error& error) {
        fail(error.what());
    }
    recording_.reset();
    recordS_ = 0;
    host_.keepScreenOn(false);
}

void Viewer::logSize(const std::string& limit, glm::ivec2 window) const {
    const glm::ivec2 size = sizeIn(window);
    log(LogLevel::detail, "pixels as the " + limit + " allows: " + std::to_string(size.x) + "x" +
                              std::to_string(size.y) + " of " + std::to_string(window.x) + "x" +
                              std::to_string(window.y));
}

Settings Viewer::settingsOf(glm::ivec2 window) const {
    Settings settings = settingsFor(choices_, window, scale_.divisor());
    if (!choices_.cascades && scene_) settings.cascades = cascadesFor(*scene_, settings);
    settings.skyRadiance = skyRadianceFor(choices_, defaults_.skyRadiance, light());
    if (choices_.sky == Sky::scene || choices_.sky == Sky::picture) {
        settings.environment = defaults_.environment;
        settings.background = defaults_.background;
    }
    if (choices_.sky == Sky::picture && sky_) {
        settings.environment = sky_;
        settings.background.reset();
    }
    return settings;
}

DirectionalLight Viewer::light() const {
    return lightFor(choices_, defaults_.light);
}

float Viewer::exposure() const {
    return defaults_.exposure.value_or(exposure_.value());
}

double Viewer::sceneTimeS() const {
    const double length = scene_->animation.durationS;
    return length > 0.0 ? std::fmod(animationS_, length) : 0.0;
}

std::string Viewer::failureOf(const std::function<void()>& part) {
    try {
        part();
        return "";
    } catch (const gl::ContextLost&) {
        throw;
    } catch (const std::exception& error) {
        if (gl::GetError() == GL_CONTEXT_LOST) throw gl::ContextLost(error.what());
        return error.what();
    }
}

void Viewer::loseContext() {
    if (bench_) endMeasuring("the GL context was lost");
    selfTest_.reset();
    gl_.reset();
    failed_.reset();
}

void Viewer::halt(const std::string& why) {
    if (request_) endMeasuring(why);
    selfTest_.reset();
    gl_.reset();
}

void Viewer::dropRenderer() {
    if (gl_) gl_->dropRenderer();
}

void Viewer::dropCaches() {
    if (gl_) gl_->dropCaches(choices_.mode);
}

// Goes back to the last choices and scene that could be rendered.
void Viewer::revert(const std::string& why, glm::ivec2 window) {
    fail(why);
    endRecording(why);
    gl_->dropRenderer();
    const Wanted wanted{choices_, scene_, window};
    failed_ = wanted;
    if (!good_ || *good_ == wanted) return;
    choices_ = good_->choices;
    if (scene_ != good_->scene) show(goodPrepared_, goodDefaults_, window);
}

void Viewer::fail(const std::string& message) {
    message_ = message;
    log(LogLevel::error, message);
}

std::string Viewer::scenePath() const {
    if (isLoading()) return scenes_.loaded().path;
    return scene_ ? scene_->path : "";
}

std::shared_ptr<const PreparedScene> Viewer::takePreparedScene(glm::ivec2 window) {
    if (!preparing_.valid()) {
        std::optional<LoadedScene> loaded = scenes_.take();
        if (!loaded) return nullptr;
        preparing_ = std::async(std::launch::async, [this, loaded = std::move(*loaded),
                                                     aspect = aspectOf(sizeIn(window))]() mutable {
            return prepared(std::move(loaded), aspect, host_);
        });
    }
    if (preparing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return nullptr;
    std::shared_ptr<const PreparedScene> ready = preparing_.get();
    return scenes_.loading() ? nullptr : ready;  // the user has chosen another scene
}

void Viewer::takeLoadedScene(glm::ivec2 window) {
    try {
        const std::shared_ptr<const PreparedScene> ready = takePreparedScene(window);
        if (!ready) return;
        for (const std::string& warning : ready->loaded.scene->warnings)
            log(LogLevel::warning, warning);
        if (scene_) choices_.lightsOff.reset();  // the first scene keeps the lights of the ShowRequest
        show(ready, ready->look, window);
        if (!defaults_.camera) {
            const Camera seen = scene_->cameras.empty() ? view_->camera(aspect_) : scene_->cameras.front();
            const std::string note = cameraNote(*scene_, "", seen, aspect_);
            if (!note.empty()) log(note);
        }
        choices_.lightAnglesDeg.reset();
    } catch (const std::exception& error) {
        if (request_) return endMeasuring(error.what());
        fail(error.what());
        endRecording(error.what());
    }
}

void Viewer::show(std::shared_ptr<const PreparedScene> prepared, const ViewDefaults& look,
                  glm::ivec2 window) {
    prepared_ = std::move(prepared);
    scene_ = prepared_->loaded.scene;
    defaults_ = look;
    choices_.grid = look.grid.value_or(choices_.grid);
    if (look.cascades) choices_.cascades = look.cascades;
    exposure_ = {};
    camera_ = 0;
    aspect_ = aspectOf(sizeIn(window));
    startView();
}

// The framed view keeps the aspect ratio that it was made for.
void Viewer::startView() {
    const std::optional<Camera>& framed = prepared_->framed;
    if (!defaults_.camera && framed)
        view_.emplace(*scene_, framed, *framed->aspectRatio, prepared_->obstacles);
    else
        view_.emplace(*scene_, defaults_.camera, aspect_, prepared_->obstacles);
}

void Viewer::reset() {
    choices_.lightAnglesDeg.reset();
    if (!scene_) return;
    startView();
    exposure_ = {};
}

void Viewer::turnLight(const glm::vec2& deg) {
    const glm::vec2 from = choices_.lightAnglesDeg.value_or(lightAnglesDeg(defaults_.light)) + deg;
    choices_.lightAnglesDeg = {std::remainder(from.x, 360.0F), std::clamp(from.y, -90.0F, 90.0F)};
}

void Viewer::showOtherScene(int step) {
    const auto count = static_cast<int>(scenes_.all().size());
    if (count > 0) choose((std::max(scenes_.find(scenePath()), 0) + step + count) % count);
}

void Viewer::choose(int scene) {
    message_.clear();  // it is about the scene that the user leaves
    scenes_.load(scenes_.all()[scene]);
}

void Viewer::showFrom(int camera) {
    if (!scene_ || camera >= static_cast<int>(scene_->cameras.size())) return;
    camera_ = camera;
    defaults_.camera = scene_->cameras[static_cast<std::size_t>(camera)];
    startView();
}

void Viewer::open(const std::string& path) {
    std::string ending = path.substr(std::min(path.find_last_of('.'), path.size()));
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".glb" || ending == ".gltf") return choose(scenes_.add(path));
    if (ending != skyExtension)
        return fail("cannot open '" + path +
                    "': it is neither a scene (.glb, .gltf) nor a sky (.hdr); convert it to one of these");
    message_.clear();
    skies_.add(path);
    choices_.sky = Sky::picture;
    choices_.skyPicture = path;
    skyPath_.clear();  // the file may have changed
}

void Viewer::followSky() {
    try {
        if (std::optional<LoadedSky> loaded = skies_.take()) {
            sky_ = std::move(*loaded);
            skyPath_ = choices_.skyPicture = skies_.loaded().path;
            log("the sky is that of " + skyPath_);
            exposure_ = {};
        }
        if (choices_.sky != Sky::picture || choices_.skyPicture == skyPath_) return;
        const int found = skies_.find(choices_.skyPicture);
        if (found < 0)
            throw Error("there is no sky '" + choices_.skyPicture + "'; copy it into the folder " +
                        host_.folder);
        choices_.skyPicture = skies_.all()[static_cast<std::size_t>(found)].path;
        if (!skies_.loading() || skies_.loaded().path != choices_.skyPicture)
            skies_.load(skies_.all()[static_cast<std::size_t>(found)]);
    } catch (const std::exception& error) {
        choices_.sky = Sky::scene;
        fail(error.what());
    }
}

void Viewer::setPixelsPerDp(float pixelsPerDp) {
    if (pixelsPerDp == host_.pixelsPerDp) return;
    host_.pixelsPerDp = pixelsPerDp;
    hud_.setPixelsPerDp(pixelsPerDp);
    touch_ = Touch(pixelsPerDp);
}

void Viewer::walk(const glm::dvec3& shares) {
    if (view_) view_->walk(shares);
}

std::optional<Viewer::Seen> Viewer::seen() {
    if (!scene_ || !gl_ || gl_->renderer() == nullptr || !good_ || good_->scene != scene_) return {};
    Renderer& renderer = *gl_->renderer();
    Seen seen{scene_->path,
              renderer.settings().size,
              view_->camera(aspect_),
              light(),
              renderer.settings(),
              exposure(),
              {},
              {},
              {},
              renderer.radiance()};
    if (!scene_->animation.channels.empty()) seen.timeS = sceneTimeS();
    if (choices_.sky == Sky::picture && sky_) seen.skyPath = skyPath_;
    seen.cameraOption = cameraOption(seen.camera, scene_->boundsWorld);
    return seen;
}

// A touch belongs to the panel or to the view, whichever it began on, until all fingers are lifted.
void Viewer::finger(const std::vector<TouchPoint>& points, double timeS) {
    if (!touching_ && !points.empty()) {
        touchesHud_ = hud_.covers(points[0].position);
        hudFinger_ = points[0];
    }
    touching_ = !points.empty();
    if (!touchesHud_) return touch_.update(points, timeS);
    const auto found = std::find_if(points.begin(), points.end(),
                                    [&](const TouchPoint& point) { return point.id == hudFinger_.id; });
    const bool down = found != points.end();
    if (down) hudFinger_ = *found;
    hud_.touch(hudFinger_.position, down);
}

}  // namespace vct::app
