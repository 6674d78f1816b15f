#include "app/android/app.h"

#include <android/window.h>

#include <cstdlib>

#include "app/android/activity.h"
#include "app/android/assets.h"
#include "app/android/thermal.h"
#include "app/log.h"
#include "gl/debug.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "vct/version.h"

namespace vct::app {

namespace {

ViewerHost hostFor(android_app& glue) {
    ANativeActivity& activity = *glue.activity;
    AAssetManager* const assets = activity.assetManager;
    ViewerHost android;
    android.backend = "android";
    android.folder = filesFolder(activity);
    android.pixelsPerDp = pixelsPerDp(glue.config);
    android.shaders = shadersFromAssets(assets);
    android.findScenes = [assets, folder = android.folder] {
        return findFiles(assets, folder, {".glb", ".gltf"});
    };
    android.findSkies = [assets, folder = android.folder] {
        return findFiles(assets, folder, {skyExtension});
    };
    android.openFile = [assets](const FileChoice& file, const std::atomic<bool>& cancelled) {
        return sceneReader(assets, file.bundled, cancelled);
    };
    // Android pauses the app when the screen goes dark, and so would end a measurement.
    android.keepScreenOn = [&activity](bool on) {
        ANativeActivity_setWindowFlags(&activity, on ? AWINDOW_FLAG_KEEP_SCREEN_ON : 0,
                                       on ? 0 : AWINDOW_FLAG_KEEP_SCREEN_ON);
    };
    android.thermalHeadroom = thermalHeadroom;
    android.defaultsFor = [](const Scene& scene, const LoadedSky& sky, double aspect) {
        ViewDefaults look;
        look.light = chooseLight(scene);
        if (sky) {
            // A scene that comes with a sky and without a light has no sun.
            if (scene.lights.empty() && scene.punctualLights.empty()) look.light.intensity = 0.0F;
            look.environment = sky;
            return look;
        }
        look.skyRadiance = chooseSky(scene, look.light);
        if (look.skyRadiance != glm::vec3(0.0F))
            look.background =
                chooseBackground(scene, chooseCamera(scene, "", aspect), aspect, look.skyRadiance);
        else if (scene.lights.empty() && !scene.punctualLights.empty())
            look.background = dimSky(look.light);
        return look;
    };
    return android;
}

}  // namespace

App::App(android_app& glue, const std::string& command) : glue_(glue) {
    ViewerHost android = hostFor(glue);
    log("vct " VCT_VERSION ", files in " + android.folder);
    const bool show = command.rfind("show", 0) == 0;
    ShowRequest request;
    std::string failure;
    try {
        if (show) request = showRequestFromText(command);
    } catch (const Error& error) {
        failure = error.what();
    }
    viewer_.emplace(std::move(android), request);
    if (!failure.empty()) viewer_->fail(failure);
    if (!command.empty() && !show) viewer_->startMeasuring(command);
}

App::~App() {
    viewer_.reset();
    log("the app ends");
}

bool App::animating() const {
    return resumed_ && glue_.window != nullptr && !halted_;
}

void App::onCommand(int command) {
    insetsUntil_ = {};
    switch (command) {
        case APP_CMD_INIT_WINDOW:
            halted_ = false;
            break;
        case APP_CMD_TERM_WINDOW:
            dropSurface();
            break;
        case APP_CMD_RESUME:
            resumed_ = true;
            viewer_->resume();
            break;
        case APP_CMD_PAUSE:
            resumed_ = false;
            break;
        case APP_CMD_CONFIG_CHANGED:
            // A phone that is unfolded, or another display, may have another density.
            viewer_->setPixelsPerDp(pixelsPerDp(glue_.config));
            break;
        case APP_CMD_LOST_FOCUS:
            viewer_->cancelTouch();
            break;
        case APP_CMD_WINDOW_REDRAW_NEEDED:
            if (animating()) frame();
            break;
        case APP_CMD_LOW_MEMORY:
            log(LogLevel::warning, "the system is low on memory");
            viewer_->dropCaches();
            // A renderer whose picture is on the screen would be rebuilt at once.
            if (!animating()) viewer_->dropRenderer();
            break;
        case APP_CMD_SAVE_STATE:
            // Any saved state tells a restarted app that the command of its intent was executed already.
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
            viewer_->draw(surface_->size(), freeArea(surface_->size(), insets()));
            show();
        }
    } catch (const gl::ContextLost& error) {
        loseContext(error.what());
    } catch (const std::exception& error) {
        // A driver that has lost the context may report any other error first.
        if (context_ && viewer_->hasObjects() && gl::GetError() == GL_CONTEXT_LOST)
            loseContext(error.what());
        else
            halt(error.what());
    }
}

// Each step makes one layer (app.h), unless it exists.
void App::prepare() {
    if (!display_) display_.emplace();
    if (surface_ && !surface_->fits(glue_.window)) dropSurface();
    if (!surface_) surface_.emplace(*display_, glue_.window);
    if (!context_) context_.emplace(*display_);
    if (!context_->makeCurrent(&*surface_))
        return halt("the window cannot be drawn into any more; leave the app and open it again");
}

void App::show() {
    switch (context_->swap(*surface_)) {
        case GlContext::Shown::yes:
            return viewer_->shown();
        case GlContext::Shown::surfaceLost:
            log(LogLevel::warning, "the window's surface was lost");
            return dropSurface();
        case GlContext::Shown::contextLost:
            throw gl::ContextLost("eglSwapBuffers");
    }
}

// Insets change without a command, for example when the device is turned from one landscape to the other.
// They are read after each command and every half second, because calling Java takes a moment.
const WindowInsets& App::insets() {
    const auto now = std::chrono::steady_clock::now();
    if (now >= insetsUntil_) {
        insets_ = windowInsets(*glue_.activity);
        insetsUntil_ = now + std::chrono::milliseconds(500);
    }
    return insets_;
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
        std::string("the GL context was lost (") + how + "); the app rebuilds everything in it");
    viewer_->loseContext();
    surface_.reset();
    context_.reset();
}

// Stops drawing until there is another window.
void App::halt(const std::string& why) {
    log(LogLevel::error, why);
    halted_ = true;
    viewer_->halt(why);
    surface_.reset();
    context_.reset();
}

bool App::onInput(const AInputEvent* event) {
    if (!isTouch(event)) return false;
    const bool cancelled =
        (AMotionEvent_getAction(event) & AMOTION_EVENT_ACTION_MASK) == AMOTION_EVENT_ACTION_CANCEL;
    if (cancelled) viewer_->cancelTouch();
    viewer_->finger(fingersAfter(event), 1e-9 * static_cast<double>(AMotionEvent_getEventTime(event)));
    return true;
}

}  // namespace vct::app
