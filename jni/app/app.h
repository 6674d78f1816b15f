// The app between two events: what it was told, what it holds, and its frame. Read frame() in app.cpp first.
//
// Layers, each made when a frame first needs it and on top of the one before: display, surface, context, GL
// objects. A lost window takes the surface only; a lost context takes the GL objects with it.
#pragma once

#include <android_native_app_glue.h>

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/egl.h"
#include "app/gl_objects.h"
#include "app/hud.h"
#include "app/orbit_view.h"
#include "app/scenes.h"
#include "app/touch.h"
#include "lab/bench_run.h"
#include "lab/self_test.h"

namespace vct::app {

class App {
  public:
    // `command`: a measurement to start with ("bench ...", lab/bench_run.h), or what to show first ("show
    // ...", choices.h), or "".
    App(android_app& glue, const std::string& command);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    // APP_CMD_*. Throws nothing.
    void onCommand(int command);
    // Returns false where the system is to do what it does with the event, as for the back button.
    bool onInput(const AInputEvent* event);

    // Whether frames are wanted: not without a window, and not while the activity is paused.
    bool animating() const;
    // One frame: throws nothing.
    void frame();

  private:
    // What a picture depends on that needs another renderer, or another try.
    struct Wanted {
        Choices choices;
        std::shared_ptr<const Scene> scene;
        glm::ivec2 window{0};
        bool operator==(const Wanted& other) const = default;
    };

    void prepare();
    void draw();
    void drawMessage();
    void drawScene();
    void drawHud(double passedS);
    void show();
    // Runs a part of a frame; returns why it failed, or "". Throws gl::ContextLost where that is the reason:
    // a driver that has lost the context may complain of anything first.
    static std::string failureOf(const std::function<void()>& part);

    void dropSurface();
    void loseContext(const std::string& how);
    void halt(const std::string& why);
    void revert(const std::string& why);

    // In app_measuring.cpp.
    void testDriver();
    void startMeasuring(const std::string& command);
    void measure();
    void endMeasuring(const std::string& failure);  // "": all is written

    std::string scenePath() const;  // of what is being loaded or shown
    void takeLoadedScene();
    void fail(const std::string& message);
    void finger(const std::vector<TouchPoint>& points, double timeS);

    android_app& glue_;
    std::string folder_;  // the app's files on the device that others can reach
    bool resumed_ = false;
    bool halted_ = false;  // nothing can be drawn until there is another window

    Scenes scenes_;
    std::shared_ptr<const Scene> scene_;
    std::optional<OrbitView> view_;
    Exposure exposure_;

    Choices choices_;
    double animationS_ = 0.0;       // what has been played, of any scene
    std::optional<Wanted> good_;    // of the last frame that could be rendered
    std::optional<Wanted> failed_;  // could not be rendered, and is not tried again
    std::string message_;

    std::optional<SelfTest> selfTest_;
    std::unique_ptr<ResultsFolder> results_;  // while something is measured
    std::optional<BenchRequest> request_;     // what is to be measured once its scene is there
    std::unique_ptr<BenchRun> bench_;         // in the context, as gl_
    int shownFrames_ = 0;

    Hud hud_;
    Touch touch_;
    bool touching_ = false, touchesDisplay_ = false;
    TouchPoint displayFinger_;

    std::optional<Display> display_;
    std::optional<Surface> surface_;
    std::optional<GlContext> context_;
    std::unique_ptr<GlObjects> gl_;

    std::chrono::steady_clock::time_point lastFrame_;
    double frameMs_ = 0.0;
    std::optional<std::array<double, stepCount>> stepMs_;
};

}  // namespace vct::app
