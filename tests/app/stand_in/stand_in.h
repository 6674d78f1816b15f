// Stands in for Android in one run of the app on a desktop: events come from a script, windows are pbuffers,
// assets are files of the source tree. EGL, GL and the renderer are real. The linker wraps EGL's entry
// points, so that tests notice the use of a dead window and leaked GL objects, and can cause the loss of a
// context.
#pragma once

#include <android_native_app_glue.h>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/free_area.h"
#include "image/image.h"

struct ANativeWindow {
    int width, height;
    bool alive;
};

struct AConfiguration {
    int density;
};

struct AAssetManager {};

struct AInputEvent {
    int type = AINPUT_EVENT_TYPE_MOTION;
    int action = AMOTION_EVENT_ACTION_DOWN;
    struct Pointer {
        int id;
        float x, y;
    };
    std::vector<Pointer> pointers = {};
    std::int64_t timeNs = 0;
};

namespace vct::test {

class StandIn {
  public:
    StandIn();
    ~StandIn();
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

    // These append events to the script. The activity is destroyed at its end.
    void command(int command);
    void window(int width, int height);  // the system makes one
    void loseWindow();
    void resize(int width, int height);
    void setDensity(int dpi);  // as when a phone is unfolded
    // Up to `count` refreshes of the display, as many as the app asks for.
    void frames(int count);
    // Frames until the app has logged a line with `text`; at most `most`.
    void framesUntilLogged(const std::string& text, int most = 20000);
    void touch(int action, const std::vector<AInputEvent::Pointer>& pointers) {
        input({AINPUT_EVENT_TYPE_MOTION, action, pointers});
    }
    void then(std::function<void()> what) { script_.push_back(std::move(what)); }
    // Starts and resumes the app and gives it a window.
    void start(int width, int height);
    void startUntilSceneShown(int width, int height);

    // Runs the app from its start to its end.
    void run();

    // The state at its start.
    std::string intentExtra;
    std::string scenes;                  // folder of the APK's scenes; the source tree's otherwise
    std::string files;                   // the app's external files folder
    std::string shadersFrom, shadersTo;  // text of the shaders, replaced
    int density = 160;
    bool restored = false;
    bool testsDriver = false;  // otherwise the self-test counts as passed before, as it takes seconds
    app::WindowInsets insets;
    std::optional<float> headroom;        // thermal headroom; empty: the device does not tell it
    std::int64_t refreshNs = 16'666'667;  // of the display

    // Faults that happen once. The context is lost at the n-th glGetError or eglSwapBuffers from now.
    void loseContextAtGlError(int n) { lossAtGlError_ = n; }
    void loseContextAtSwap(int n) { lossAtSwap_ = n; }
    void failSurface() { failSurface_ = true; }

    // Observations of the app.
    struct LogLine {
        int priority;
        std::string text;
    };
    std::vector<LogLine> log;
    bool logged(const std::string& text) const;
    std::string errors() const;       // lines of the log that are errors
    std::vector<std::string> misuse;  // of windows, surfaces, the context; leaks of GL objects
    int shown = 0;                    // frames on the screen
    int contextsMade = 0;
    bool capture = false;   // keep the frames that are shown
    Image screen;           // the last frame shown, while `capture`; 8-bit values over 255
    bool finished = false;  // ANativeActivity_finish
    std::uint32_t windowFlags = 0;
    int traceDepth = 0;
    std::vector<std::string> traceSections;

    android_app glue{};

    // For the entry points of the NDK and EGL.
    int poll(int timeoutMs, void** data);
    std::function<void(std::int64_t)> atRefresh;  // asked for by the app
    int lossAtGlError_ = 0, lossAtSwap_ = 0;
    bool contextLost = false;
    bool failSurface_ = false;

  private:
    // `what` runs when the app asks for events.
    void event(std::function<void()> what);
    void input(AInputEvent input);
    void deliver(int command);
    void takeWindow();

    ANativeActivity activity_{};
    AAssetManager assets_;
    AConfiguration configuration_{160};
    std::deque<std::function<void()>> script_;
    std::vector<std::unique_ptr<ANativeWindow>> windows_;
    int framesLeft_ = 0;
    std::string untilLogged_;
    android_poll_source source_{};
    std::function<void()> pending_;  // run by the app through source_
    std::int64_t timeNs_ = 0;
};

// The stand-in that runs; null outside run().
StandIn* currentStandIn();

// The number of live GL objects of the app: "Textures", "Buffers", ...
int liveGlObjects(const std::string& kind);

}  // namespace vct::test
