#include "app/app.h"

#include <android/window.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "app/log.h"
#include "gl/debug.h"
#include "scene/camera.h"

namespace vct::app {

namespace {

constexpr const char* firstScene = "cornell.glb";
const glm::vec3 background(0.08F);

float pixelsPerDp(AConfiguration* configuration) {
    const int density = AConfiguration_getDensity(configuration);
    // Special values mark "any" and "none".
    return density > 0 && density < ACONFIGURATION_DENSITY_ANY ? static_cast<float>(density) / 160.0F : 1.0F;
}

std::string filesFolder(const ANativeActivity& activity) {
    for (const char* path : {activity.externalDataPath, activity.internalDataPath})
        if (path != nullptr && *path != '\0') {
            std::error_code ignored;
            std::filesystem::create_directories(path, ignored);
            return path;
        }
    return "";
}

}  // namespace

App::App(android_app& glue, const std::string& command)
    : glue_(glue),
      folder_(filesFolder(*glue.activity)),
      loader_(glue.activity->assetManager),
      pixelsPerDp_(pixelsPerDp(glue.config)),
      hud_(pixelsPerDp_),
      touch_(pixelsPerDp_),
      lastFrame_(std::chrono::steady_clock::now()) {
    log("vct " VCT_VERSION ", files in " + folder_);
    rescan();
    std::string scene = firstScene;
    if (command.rfind("show", 0) == 0) {
        try {
            const ShowRequest request = showRequestFromText(command);
            choices_ = request.choices;
            animationS_ = request.timeS;
            if (!request.display) hud_.turnOff();
            if (!request.scene.empty()) scene = request.scene;
        } catch (const Error& error) {
            fail(error.what());
        }
    }
    const auto first = findScene(scene);
    if (!scenes_.empty()) chooseScene(first == scenes_.end() ? scenes_.front() : *first);
    if (!command.empty() && command.rfind("show", 0) != 0) startMeasuring(command);
}

App::~App() {
    loader_.cancel();
    bench_.reset();  // in its context
    gl_.reset();
    log("the app ends");
}

bool App::animating() const {
    return resumed_ && glue_.window != nullptr && !halted_;
}

void App::onCommand(int command) {
    switch (command) {
        case APP_CMD_INIT_WINDOW:
            halted_ = false;
            break;
        case APP_CMD_TERM_WINDOW:
            dropSurface();
            break;
        case APP_CMD_RESUME:
            resumed_ = true;
            lastFrame_ = std::chrono::steady_clock::now();
            break;
        case APP_CMD_PAUSE:
            resumed_ = false;
            break;
        case APP_CMD_LOST_FOCUS:
            touch_.cancel();
            break;
        case APP_CMD_WINDOW_REDRAW_NEEDED:
            if (animating()) frame();
            break;
        case APP_CMD_LOW_MEMORY:
            log(LogLevel::warning, "the system is low on memory");
            // What is on the screen is needed again at once.
            if (!animating() && gl_) gl_->dropRenderer();
            break;
        case APP_CMD_SAVE_STATE:
            // Whatever is here when the app comes back says that its intent has been followed already.
            glue_.savedState = std::malloc(1);
            glue_.savedStateSize = glue_.savedState != nullptr ? 1 : 0;
            break;
        default:
            break;
    }
}

void App::frame() {
    if (!animating()) return;
    try {
        prepare();
        if (surface_) {
            takeLoadedScene();
            draw();
            show();
        }
    } catch (const gl::ContextLost& error) {
        loseContext(error.what());
    } catch (const std::exception& error) {
        // A driver that has lost the context may complain of anything first.
        if (context_ && gl_ && gl::GetError() == GL_CONTEXT_LOST)
            loseContext(error.what());
        else
            halt(error.what());
    }
}

// Every step is one layer, and does nothing where it is there.
void App::prepare() {
    if (!display_) display_.emplace();
    if (surface_ && !surface_->fits(glue_.window)) dropSurface();
    if (!surface_) surface_.emplace(*display_, glue_.window);
    if (!context_) context_.emplace(*display_);
    if (!context_->makeCurrent(&*surface_)) return halt("the window cannot be drawn into any more");
    if (!gl_) gl_ = std::make_unique<GlObjects>(shadersFromAssets(glue_.activity->assetManager));
}

void App::draw() {
    const auto now = std::chrono::steady_clock::now();
    const double passedS = std::chrono::duration<double>(now - lastFrame_).count();
    lastFrame_ = now;
    if (choices_.play) animationS_ += passedS;
    frameMs_ = frameMs_ == 0.0 ? 1e3 * passedS : 0.8 * frameMs_ + 0.2 * 1e3 * passedS;
    if (!gl_->missing().empty()) return drawMessage();

    testDriver();
    const bool measuring = request_ && !loader_.busy() && selfTest_;
    if (measuring)
        measure();
    else
        drawScene();
    const Renderer* const renderer = bench_ ? bench_->renderer() : measuring ? nullptr : gl_->renderer();
    if (renderer != nullptr)
        gl_->presenter().draw(*renderer, surface_->size());
    else
        clearWindow(surface_->size(), background);
    drawHud(passedS);
}

// On a driver that lacks something.
void App::drawMessage() {
    if (request_) endMeasuring(gl_->missing());
    const glm::ivec2 window = surface_->size();
    clearWindow(window, background);
    hud_.buildMessage("This device cannot run voxel cone tracing.", gl_->missing(), window, freeArea());
    gl_->hud().draw(hud_.drawData(), window);
    gl::checkErrors("message");
}

void App::drawHud(double passedS) {
    const glm::ivec2 window = surface_->size();
    const Gesture gesture = touch_.take();
    if (view_) view_->apply(gesture, window);

    HudContent content;
    content.choices = &choices_;
    int scene = sceneIndex();
    const int sceneBefore = scene;
    content.scene = &scene;
    content.scenes = &scenes_;
    if (scene_) content.sceneLightDeg = lightAnglesDeg(chooseLight(*scene_));
    content.frameMs = frameMs_;
    content.stepMs = stepMs_ ? &*stepMs_ : nullptr;
    content.renderSize = settingsFor(choices_, window).size;
    content.animated = scene_ && !scene_->animation.channels.empty();
    content.measuring = request_.has_value();
    if (loader_.busy())
        content.status = "loading " + loading_.name;
    else if (!selfTest_)
        content.status = "testing the driver";
    else if (bench_)
        content.status = "measuring " + bench_->progress();
    content.message = message_;
    const HudActions actions = hud_.build(content, window, freeArea(), passedS);
    gl_->hud().draw(hud_.drawData(), window);
    gl::checkErrors("display");

    if (scene != sceneBefore) chooseScene(scenes_[static_cast<std::size_t>(scene)]);
    if (actions.rescan) rescan();
    if (actions.resetView && scene_) view_.emplace(*scene_);
    if (actions.dismiss) message_.clear();
    if (actions.measure && request_)
        endMeasuring("stopped by hand");
    else if (actions.measure)
        startMeasuring("bench preset=" + choices_.preset);
}

void App::drawScene() {
    const Wanted wanted{choices_, scene_, surface_->size()};
    if (!scene_ || (failed_ && *failed_ == wanted)) return;
    const glm::ivec2 window = surface_->size();
    try {
        Renderer& renderer = gl_->rendererFor(scene_, choices_, window);
        if (const Animation& animation = scene_->animation; !animation.channels.empty()) {
            const double length = animation.durationS;
            const Pose pose = poseAt(animation, length > 0.0 ? std::fmod(animationS_, length) : 0.0);
            renderer.setPose(pose);
            renderer.setLightDirection(posed(lightFor(choices_, *scene_), pose).towardsLight);
            if (!scene_->cameras.empty()) view_->follow(posed(scene_->cameras.front(), pose));
        }
        const glm::dvec2 size(settingsFor(choices_, window).size);
        if (choices_.timeSteps) renderer.timer().startRecording();
        renderer.frame(choices_.mode, view_->camera(size.x / size.y));
        stepMs_.reset();
        if (choices_.timeSteps) {
            const StepTimes times = renderer.timer().stopRecording();
            stepMs_.emplace();
            for (std::size_t i = 0; i < stepCount; ++i)
                (*stepMs_)[i] = times.stepMs[i].back();
        }
        good_ = wanted;
        failed_.reset();
    } catch (const gl::ContextLost&) {
        throw;
    } catch (const std::exception& error) {
        if (gl::GetError() == GL_CONTEXT_LOST) throw gl::ContextLost(error.what());
        revert(error.what());
    }
}

void App::show() {
    switch (context_->swap(*surface_)) {
        case GlContext::Shown::yes:
            ++shownFrames_;
            return;
        case GlContext::Shown::surfaceLost:
            log(LogLevel::warning, "the window's surface was lost");
            return dropSurface();
        case GlContext::Shown::contextLost:
            throw gl::ContextLost("eglSwapBuffers");
    }
}

void App::dropSurface() {
    try {
        if (context_) context_->makeCurrent(nullptr);
    } catch (const gl::ContextLost& error) {
        loseContext(error.what());
    }
    surface_.reset();
}

void App::loseContext(const std::string& how) {
    log(LogLevel::warning,
        std::string("the GL context was lost (") + how + "); everything in it is made anew");
    if (bench_) endMeasuring("the GL context was lost");
    gl_.reset();
    surface_.reset();
    context_.reset();
    failed_.reset();
}

// Drawing has no chance in this window.
void App::halt(const std::string& why) {
    log(LogLevel::error, why);
    halted_ = true;
    if (request_) endMeasuring(why);
    gl_.reset();
    surface_.reset();
    context_.reset();
}

// Back to what could be rendered.
void App::revert(const std::string& why) {
    fail(why);
    gl_->dropRenderer();
    const Wanted wanted{choices_, scene_, surface_->size()};
    failed_ = wanted;
    if (!good_ || *good_ == wanted) return;
    choices_ = good_->choices;
    if (scene_ != good_->scene) {
        scene_ = good_->scene;
        view_.emplace(*scene_);
    }
}

void App::fail(const std::string& message) {
    message_ = message;
    log(LogLevel::error, message);
}

// Once, and not before the window has shown something: it takes a moment.
void App::testDriver() {
    if (selfTest_ || shownFrames_ == 0) return;
    selfTest_ = runSelfTest(gl_->capabilities(), shadersFromAssets(glue_.activity->assetManager));
    const std::string text =
        (selfTest_->passed ? "self-test passed: " : "self-test FAILED: ") + selfTest_->text;
    if (selfTest_->passed)
        log(text);
    else
        fail(text);
}

void App::startMeasuring(const std::string& command) {
    log(command);
    try {
        results_ = std::make_unique<ResultsFolder>(folder_ + "/results");
        BenchRequest request = benchRequestFromText(command);
        rescan();
        const std::string current = loader_.busy() ? loading_.path : scene_ ? scene_->path : "";
        const auto found = findScene(request.scene.empty() ? current : request.scene);
        if (found == scenes_.end())
            throw Error("there is no scene " + request.scene + "; copy it into " + folder_);
        request.scene = found->name;
        if (found->path != current) chooseScene(*found);
        request_ = request;
        // A screen that goes dark pauses the app.
        ANativeActivity_setWindowFlags(glue_.activity, AWINDOW_FLAG_KEEP_SCREEN_ON, 0);
    } catch (const std::exception& error) {
        endMeasuring(error.what());
    }
}

// A frame of it.
void App::measure() {
    try {
        if (!bench_) {
            gl_->dropRenderer();
            stepMs_.reset();
            bench_ = std::make_unique<BenchRun>(
                BenchRun::Input{*request_, scene_, gl_->capabilities(),
                                shadersFromAssets(glue_.activity->assetManager), "android",
                                selfTestJson(*selfTest_), [](const std::string& line) { log(line); }},
                results_->path());
        }
        if (!bench_->advance()) endMeasuring("");
    } catch (const gl::ContextLost&) {
        throw;
    } catch (const std::exception& error) {
        if (gl::GetError() == GL_CONTEXT_LOST) throw gl::ContextLost(error.what());
        endMeasuring(error.what());
    }
}

void App::endMeasuring(const std::string& failure) {
    bench_.reset();
    request_.reset();
    ANativeActivity_setWindowFlags(glue_.activity, 0, AWINDOW_FLAG_KEEP_SCREEN_ON);
    if (failure.empty()) {
        message_ = "measured: " + folder_ + "/results";
        log(message_);
    } else {
        fail("measuring failed: " + failure);
    }
    try {
        if (results_ && failure.empty()) results_->done(selfTest_->text);
        if (results_ && !failure.empty()) results_->failed(failure);
    } catch (const Error& error) {
        fail(error.what());
    }
    results_.reset();
}

void App::rescan() {
    scenes_ = findScenes(glue_.activity->assetManager, folder_);
}

std::vector<SceneFile>::const_iterator App::findScene(const std::string& nameOrPath) const {
    return std::find_if(scenes_.begin(), scenes_.end(), [&](const SceneFile& scene) {
        return scene.name == nameOrPath || scene.path == nameOrPath;
    });
}

int App::sceneIndex() const {
    const std::string path = loader_.busy() ? loading_.path : scene_ ? scene_->path : "";
    const auto found = std::find_if(scenes_.begin(), scenes_.end(),
                                    [&](const SceneFile& scene) { return scene.path == path; });
    return found == scenes_.end() ? -1 : static_cast<int>(found - scenes_.begin());
}

void App::chooseScene(const SceneFile& scene) {
    loading_ = scene;
    log("loading " + scene.path);
    loader_.start(scene);
}

void App::takeLoadedScene() {
    std::optional<SceneLoader::Result> result = loader_.take();
    if (!result) return;
    if (!result->scene) {
        if (request_)
            endMeasuring(result->error);
        else
            fail(result->error);
        return;
    }
    for (const std::string& warning : result->scene->warnings)
        log(LogLevel::warning, warning);
    log(result->file.path + ": " + std::to_string(result->scene->triangleCount()) + " triangles");
    scene_ = result->scene;
    view_.emplace(*scene_);
    choices_.lightAnglesDeg.reset();
    message_.clear();
}

bool App::onInput(const AInputEvent* event) {
    if (AInputEvent_getType(event) != AINPUT_EVENT_TYPE_MOTION) return false;
    const int action = AMotionEvent_getAction(event);
    const int kind = action & AMOTION_EVENT_ACTION_MASK;
    const auto lifted = static_cast<std::size_t>((action & AMOTION_EVENT_ACTION_POINTER_INDEX_MASK) >>
                                                 AMOTION_EVENT_ACTION_POINTER_INDEX_SHIFT);
    std::vector<TouchPoint> points;
    const bool none = kind == AMOTION_EVENT_ACTION_UP || kind == AMOTION_EVENT_ACTION_CANCEL;
    for (std::size_t i = 0; !none && i < AMotionEvent_getPointerCount(event); ++i)
        if (kind != AMOTION_EVENT_ACTION_POINTER_UP || i != lifted)
            points.push_back({AMotionEvent_getPointerId(event, i),
                              {AMotionEvent_getX(event, i), AMotionEvent_getY(event, i)}});
    if (kind == AMOTION_EVENT_ACTION_CANCEL) touch_.cancel();
    finger(points, 1e-9 * static_cast<double>(AMotionEvent_getEventTime(event)));
    return true;
}

// Whoever a touch began with gets all of it.
void App::finger(const std::vector<TouchPoint>& points, double timeS) {
    if (!touching_ && !points.empty()) {
        touchesDisplay_ = hud_.covers(points[0].position);
        displayFinger_ = points[0];
    }
    touching_ = !points.empty();
    if (!touchesDisplay_) return touch_.update(points, timeS);
    const auto found = std::find_if(points.begin(), points.end(),
                                    [&](const TouchPoint& point) { return point.id == displayFinger_.id; });
    const bool down = found != points.end();
    if (down) displayFinger_ = *found;
    hud_.touch(displayFinger_.position, down);
}

glm::ivec4 App::freeArea() const {
    const glm::ivec2 window = surface_->size();
    const ARect& r = glue_.contentRect;
    const glm::ivec4 free =
        glm::clamp(glm::ivec4(r.left, r.top, r.right, r.bottom), glm::ivec4(0), glm::ivec4(window, window));
    // Before the first layout, and just after a rotation, it says nothing of use.
    const bool plausible = free.z - free.x > window.x / 2 && free.w - free.y > window.y / 2;
    return plausible ? free : glm::ivec4(0, 0, window);
}

}  // namespace vct::app
