// Plays Android's NativeActivity for an app's library, on a real thread of the app's glue code:
//
//     activity APK ABI FILES COMMAND STEP...
//
// FILES is the app's folder and COMMAND the extra "vct" of its intent. The steps are those of the table
// below; a step with arguments is one word of the shell, as in 'window 96 64'. The exit code is 1 if a step
// failed or the app did what Android does not allow.
#include <android/native_activity.h>
#include <dlfcn.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <sstream>
#include <utility>

#include "app_library.h"
#include "java.h"
#include "stand_in.h"

namespace {

using stand_in::State;
using stand_in::state;

constexpr double waitS = 900.0;  // longer than any frame under emulation on a busy machine

double nowS() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Activity {
  public:
    Activity(const std::string& apk, const std::string& abi, const char* files, const std::string& command) {
        state().apk = apk;
        void* const library = stand_in::loadAppLibrary(apk + "!/lib/" + abi, "libvct.so");
        onCreate_ = reinterpret_cast<ANativeActivity_createFunc*>(dlsym(library, "ANativeActivity_onCreate"));
        activity_.callbacks = &callbacks_;
        stand_in::makeJava(command, activity_.vm, activity_.env, activity_.clazz);
        activity_.internalDataPath = activity_.externalDataPath = files;
        activity_.assetManager = stand_in::assetManager();
    }

    // Returns whether the step succeeded.
    bool run(const std::string& step) {
        std::istringstream words(step);
        std::string name;
        words >> name;
        const auto found = steps_.find(name);
        if (found != steps_.end()) return found->second(words);
        std::fprintf(stderr, "activity: error: there is no step '%s'\n", name.c_str());
        return false;
    }

  private:
    using Step = std::function<bool(std::istringstream&)>;

    static bool waitUntil(const std::function<bool()>& condition) {
        const double start = nowS();
        while (!condition()) {
            if (nowS() - start > waitS) return false;
            usleep(1000);
        }
        return true;
    }

    bool create() {
        logStart_ = stand_in::logSize();
        onCreate_(&activity_, saved_, savedSize_);
        callbacks_.onInputQueueCreated(&activity_, queue_);
        return true;
    }
    bool destroy() {
        callbacks_.onInputQueueDestroyed(&activity_, queue_);
        callbacks_.onDestroy(&activity_);
        return state().surfaces == 0 && state().traceDepth == 0;
    }
    bool save() {
        std::free(saved_);
        saved_ = callbacks_.onSaveInstanceState(&activity_, &savedSize_);
        return true;
    }
    bool discard() {
        std::free(std::exchange(saved_, nullptr));
        savedSize_ = 0;
        return true;
    }
    bool createWindow(std::istringstream& words) {
        window_ = new ANativeWindow{0, 0};
        words >> window_->width >> window_->height;
        callbacks_.onNativeWindowCreated(&activity_, window_);
        return layOut();
    }
    bool resize(std::istringstream& words) {
        words >> window_->width >> window_->height;
        callbacks_.onConfigurationChanged(&activity_);
        if (callbacks_.onNativeWindowResized != nullptr)
            callbacks_.onNativeWindowResized(&activity_, window_);
        layOut();
        if (callbacks_.onNativeWindowRedrawNeeded != nullptr)
            callbacks_.onNativeWindowRedrawNeeded(&activity_, window_);
        return true;
    }
    bool layOut() {
        const ARect content{0, 0, window_->width, window_->height};
        callbacks_.onContentRectChanged(&activity_, &content);
        return true;
    }
    // The window is not freed, so that later use is noticed.
    bool loseWindow() {
        callbacks_.onNativeWindowDestroyed(&activity_, window_);
        window_->alive = false;
        return true;
    }
    bool showFrames(std::istringstream& words) {
        int count = 0;
        words >> count;
        const int last = state().frames + count;
        return waitUntil([last] { return state().frames >= last; });
    }
    // Several refreshes of the display pass without a frame.
    static bool showNoFrames() {
        const int before = state().frames;
        usleep(300'000);
        return state().frames == before;
    }
    bool waitForLog(std::istringstream& words) {
        std::string text;
        std::getline(words >> std::ws, text);
        return waitUntil([&] { return stand_in::isLogged(text, logStart_); });
    }
    static bool writePicture(std::istringstream& words) {
        const std::lock_guard lock(state().mutex);
        words >> state().picturePath;
        return true;
    }
    bool send(int type, std::istringstream& words) {
        auto* const event = new AInputEvent{type, 0, static_cast<std::int64_t>(1e9 * nowS()), {}};
        words >> event->action;
        for (AInputEvent::Point point{}; words >> point.id >> point.x >> point.y;)
            event->points.push_back(point);
        const int answers = state().eventsFinished + 1;
        stand_in::send(queue_, event);
        return waitUntil([answers] { return state().eventsFinished >= answers; });
    }
    static bool sleep(std::istringstream& words) {
        double seconds = 0.0;
        words >> seconds;
        usleep(static_cast<useconds_t>(1e6 * seconds));
        return true;
    }
    // A call of Android that has no arguments.
    Step call(void (*ANativeActivityCallbacks::*callback)(ANativeActivity*)) {
        return [this, callback](std::istringstream&) {
            (callbacks_.*callback)(&activity_);
            return true;
        };
    }

    const std::map<std::string, Step> steps_ = {
        {"create", [this](auto&) { return create(); }},
        {"start", call(&ANativeActivityCallbacks::onStart)},
        {"resume", call(&ANativeActivityCallbacks::onResume)},
        {"pause", call(&ANativeActivityCallbacks::onPause)},
        {"stop", call(&ANativeActivityCallbacks::onStop)},
        {"save", [this](auto&) { return save(); }},        // what is saved is given to the next create
        {"discard", [this](auto&) { return discard(); }},  // discards it
        {"destroy", [this](auto&) { return destroy(); }},
        {"low-memory", call(&ANativeActivityCallbacks::onLowMemory)},
        {"focus",  // 1 or 0
         [this](auto& words) {
             int focus = 0;
             words >> focus;
             callbacks_.onWindowFocusChanged(&activity_, focus);
             return true;
         }},
        {"window", [this](auto& words) { return createWindow(words); }},  // WIDTH HEIGHT
        {"resize", [this](auto& words) { return resize(words); }},        // WIDTH HEIGHT
        {"lose-window", [this](auto&) { return loseWindow(); }},
        {"frames", [this](auto& words) { return showFrames(words); }},  // COUNT: waits for so many
        {"no-frames", [](auto&) { return showNoFrames(); }},
        {"log",
         [this](auto& words) { return waitForLog(words); }},  // TEXT: waits for it, since the last create
        {"picture",
         [](auto& words) { return writePicture(words); }},  // FILE.ppm: the next frame is written there
        {"touch",
         [this](auto& words) { return send(AINPUT_EVENT_TYPE_MOTION, words); }},  // ACTION [ID X Y]...
        {"key", [this](auto& words) { return send(AINPUT_EVENT_TYPE_KEY, words); }},
        {"sleep", [](auto& words) { return sleep(words); }},  // SECONDS
    };

    ANativeActivity_createFunc* onCreate_ = nullptr;
    ANativeActivityCallbacks callbacks_{};
    ANativeActivity activity_{};
    AInputQueue* queue_ = stand_in::createInputQueue();
    ANativeWindow* window_ = nullptr;
    void* saved_ = nullptr;
    std::size_t savedSize_ = 0, logStart_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 5) {
        std::fprintf(stderr, "usage: activity APK ABI FILES COMMAND STEP...\n");
        return 2;
    }
    Activity activity(argv[1], argv[2], argv[3], argv[4]);
    bool good = true;
    for (int i = 5; i < argc; ++i) {
        const double start = nowS();
        const int framesBefore = state().frames;
        const bool succeeded = activity.run(argv[i]);
        std::fprintf(stderr, "step: %s: %s, %.1f s, %d frames\n", argv[i], succeeded ? "ok" : "FAILED",
                     nowS() - start, state().frames - framesBefore);
        good = good && succeeded;
    }
    // The libraries of Android and of the host each have functions for a normal end, which the other would
    // not expect.
    std::fflush(nullptr);
    _exit(good && state().misuses == 0 ? 0 : 1);
}
