#include "app/app.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/activity.h"
#include "app/log.h"
#include "gl/debug.h"
#include "scene/camera.h"

namespace vct::app {

namespace {

constexpr const char* firstScene = "cornell.glb";
const glm::vec3 background(0.08F);

}  // namespace

App::App(android_app& glue, const std::string& command)
    : glue_(glue),
      folder_(filesFolder(*glue.activity)),
      scenes_(glue.activity->assetManager, folder_),
      hud_(pixelsPerDp(glue.config)),
      touch_(pixelsPerDp(glue.config)),
      lastFrame_(std::chrono::steady_clock::now()) {
    log("vct " VCT_VERSION ", files in " + folder_);
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
    const int first = std::max(scenes_.find(scene), 0);
    if (!scenes_.all().empty()) scenes_.load(scenes_.all()[first]);
    if (!command.empty() && command.rfind("show", 0) != 0) startMeasuring(command);
}

App::~App() {
    scenes_.cancel();
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
    const bool measuring = request_ && !scenes_.loading() && selfTest_;
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
    hud_.buildMessage("This device cannot run voxel cone tracing.", gl_->missing(), window,
                      freeArea(glue_.contentRect, window));
    gl_->hud().draw(hud_.drawData(), window);
    gl::checkErrors("message");
}

void App::drawHud(double passedS) {
    const glm::ivec2 window = surface_->size();
    const Gesture gesture = touch_.take();
    if (view_) view_->apply(gesture, window);

    HudContent content;
    content.choices = &choices_;
    int scene = scenes_.find(scenePath());
    const int sceneBefore = scene;
    content.scene = &scene;
    content.scenes = &scenes_.all();
    if (scene_) content.sceneLightDeg = lightAnglesDeg(chooseLight(*scene_));
    content.frameMs = frameMs_;
    content.stepMs = stepMs_ ? &*stepMs_ : nullptr;
    content.renderSize = settingsFor(choices_, window).size;
    content.animated = scene_ && !scene_->animation.channels.empty();
    content.measuring = request_.has_value();
    if (scenes_.loading())
        content.status = "loading " + scenes_.loaded().name;
    else if (!selfTest_)
        content.status = "testing the driver";
    else if (bench_)
        content.status = "measuring " + bench_->progress();
    content.message = message_;
    const HudActions actions = hud_.build(content, window, freeArea(glue_.contentRect, window), passedS);
    gl_->hud().draw(hud_.drawData(), window);
    gl::checkErrors("display");

    if (scene != sceneBefore) scenes_.load(scenes_.all()[scene]);
    if (actions.rescan) scenes_.rescan();
    if (actions.resetView && scene_) view_.emplace(*scene_, aspectOf(surface_->size()));
    if (actions.dismiss) message_.clear();
    if (actions.measure && request_)
        endMeasuring("stopped by hand");
    else if (actions.measure)
        startMeasuring("bench preset=" + choices_.preset);
}

void App::drawScene() {
    const Wanted wanted{choices_, scene_, surface_->size()};
    if (!scene_ || (failed_ && *failed_ == wanted)) return;
    const std::string failure = failureOf([&] {
        Renderer& renderer = gl_->rendererFor(scene_, choices_, wanted.window);
        if (const Animation& animation = scene_->animation; !animation.channels.empty()) {
            const double length = animation.durationS;
            const Pose pose = poseAt(animation, length > 0.0 ? std::fmod(animationS_, length) : 0.0);
            renderer.setPose(pose);
            renderer.setLightDirection(posed(lightFor(choices_, *scene_), pose).towardsLight);
            if (!scene_->cameras.empty()) view_->follow(posed(scene_->cameras.front(), pose));
        }
        const glm::dvec2 size(settingsFor(choices_, wanted.window).size);
        if (choices_.timeSteps) renderer.timer().startRecording();
        renderer.frame(choices_.mode, view_->camera(size.x / size.y));
        stepMs_.reset();
        if (choices_.timeSteps) {
            const StepTimes times = renderer.timer().stopRecording();
            stepMs_.emplace();
            for (std::size_t i = 0; i < stepCount; ++i)
                (*stepMs_)[i] = times.stepMs[i].back();
        }
    });
    if (!failure.empty()) return revert(failure);
    good_ = wanted;
    failed_.reset();
}

std::string App::failureOf(const std::function<void()>& part) {
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
        view_.emplace(*scene_, aspectOf(surface_->size()));
    }
}

void App::fail(const std::string& message) {
    message_ = message;
    log(LogLevel::error, message);
}

std::string App::scenePath() const {
    if (scenes_.loading()) return scenes_.loaded().path;
    return scene_ ? scene_->path : "";
}

void App::takeLoadedScene() {
    std::shared_ptr<const Scene> loaded;
    try {
        loaded = scenes_.take();
    } catch (const std::exception& error) {
        return request_ ? endMeasuring(error.what()) : fail(error.what());
    }
    if (!loaded) return;
    scene_ = loaded;
    for (const std::string& warning : scene_->warnings)
        log(LogLevel::warning, warning);
    log(scene_->path + ": " + std::to_string(scene_->triangleCount()) + " triangles");
    const double aspect = aspectOf(surface_->size());
    view_.emplace(*scene_, aspect);
    const std::string note = cameraNote(*scene_, "", view_->camera(aspect), aspect);
    if (!note.empty()) log(note);
    choices_.lightAnglesDeg.reset();
    message_.clear();
}

bool App::onInput(const AInputEvent* event) {
    if (AInputEvent_getType(event) != AINPUT_EVENT_TYPE_MOTION) return false;
    const bool cancelled =
        (AMotionEvent_getAction(event) & AMOTION_EVENT_ACTION_MASK) == AMOTION_EVENT_ACTION_CANCEL;
    if (cancelled) touch_.cancel();
    finger(fingersAfter(event), 1e-9 * static_cast<double>(AMotionEvent_getEventTime(event)));
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

}  // namespace vct::app
