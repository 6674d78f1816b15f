// The app on Android. It owns a viewer (viewer.h) and keeps it while windows and contexts come and go. Read
// frame() in app.cpp first.
//
// The layers are display, surface, context and GL objects. Each needs the one before it, and is made when a
// frame first needs it. If the window is lost, only the surface is destroyed; if the context is lost, the GL
// objects are destroyed with it.
#pragma once

#include <android_native_app_glue.h>

#include <chrono>
#include <optional>
#include <string>

#include "app/android/egl.h"
#include "app/free_area.h"
#include "app/viewer.h"

namespace vct::app {

class App {
  public:
    // `command`: a measurement ("bench ...", lab/bench_run.h), the first scene and choices ("show ...",
    // choices.h), or "".
    App(android_app& glue, const std::string& command);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    // Handles an APP_CMD_* of the glue code. Throws nothing.
    void onCommand(int command);
    // Returns false if the system is to handle the event (for example the back button).
    bool onInput(const AInputEvent* event);

    // True while there is a window that can be drawn into and the activity is not paused.
    bool animating() const;
    // Draws one frame. Throws nothing.
    void frame();

  private:
    void prepare();
    void show();
    const WindowInsets& insets();
    void dropSurface();
    void loseContext(const std::string& how);
    void halt(const std::string& why);

    android_app& glue_;
    bool resumed_ = false;
    WindowInsets insets_;
    std::chrono::steady_clock::time_point insetsUntil_;  // the time until which insets_ is used
    bool halted_ = false;  // drawing failed; nothing is drawn until there is another window

    std::optional<Display> display_;
    std::optional<Surface> surface_;
    std::optional<GlContext> context_;
    std::optional<Viewer> viewer_;  // its GL objects are in the context
};

}  // namespace vct::app
