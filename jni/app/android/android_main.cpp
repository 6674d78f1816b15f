// The app's entry point: native_app_glue calls android_main on a thread of its own, which ends when it
// returns.
#include <android/trace.h>
#include <android_native_app_glue.h>

#include <optional>

#include "app/android/activity.h"
#include "app/android/app.h"
#include "app/android/frame_clock.h"
#include "app/log.h"
#include "core/trace.h"

namespace {

using vct::app::App;

void onCommand(android_app* glue, int32_t command) {
    static_cast<App*>(glue->userData)->onCommand(command);
}

int32_t onInput(android_app* glue, AInputEvent* event) {
    return static_cast<App*>(glue->userData)->onInput(event) ? 1 : 0;
}

// Waits for an event (a refresh of the display is one, if it was requested) and handles all that are pending.
void handleEvents(android_app* glue) {
    android_poll_source* source = nullptr;
    bool wait = true;
    while (!glue->destroyRequested &&
           ALooper_pollOnce(wait ? -1 : 0, nullptr, nullptr, reinterpret_cast<void**>(&source)) >= 0) {
        if (source != nullptr) source->process(glue, source);
        wait = false;
        source = nullptr;
    }
}

void run(android_app* glue, vct::app::FrameClock& frameClock) {
    // The command applies to the first start only, not to a restart after the system ended the app.
    const bool restored = glue->savedState != nullptr;
    App app(*glue, restored ? "" : vct::app::intentExtra(*glue->activity, "vct"));
    glue->userData = &app;
    glue->onAppCmd = onCommand;
    glue->onInputEvent = onInput;
    while (!glue->destroyRequested) {
        if (app.animating()) frameClock.request();
        handleEvents(glue);
        if (frameClock.take()) app.frame();
    }
}

}  // namespace

void android_main(android_app* glue) {
    vct::traceFunctions = {ATrace_beginSection, ATrace_endSection};
    std::optional<vct::app::FrameClock> frameClock;
    try {
        run(glue, frameClock.emplace());
    } catch (const std::exception& error) {
        vct::app::log(vct::app::LogLevel::error, error.what());
    }
    glue->onAppCmd = nullptr;
    glue->onInputEvent = nullptr;
    // If the app ends by itself, the glue code still expects the activity's end.
    if (!glue->destroyRequested) ANativeActivity_finish(glue->activity);
    while (!glue->destroyRequested)
        handleEvents(glue);
}
