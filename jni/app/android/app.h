// The app on Android: what holds a viewer (viewer.h) while windows and contexts come and go. Read frame() in
// app.cpp first.
//
// Layers, each made when a frame first needs it and on top of the one before: display, surface, context, GL
// objects. A lost window takes the surface only; a lost context takes the GL objects with it.
#pragma once

#include <android_native_app_glue.h>

#include <optional>
#include <string>

#include "app/android/egl.h"
#include "app/viewer.h"

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
    void prepare();
    void show();
    void dropSurface();
    void loseContext(const std::string& how);
    void halt(const std::string& why);

    android_app& glue_;
    bool resumed_ = false;
    bool halted_ = false;  // nothing can be drawn until there is another window

    std::optional<Display> display_;
    std::optional<Surface> surface_;
    std::optional<GlContext> context_;
    std::optional<Viewer> viewer_;  // its GL objects are in the context
};

}  // namespace vct::app
