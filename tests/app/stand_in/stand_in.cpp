#include "stand_in.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/viewer.h"

namespace vct::test {

namespace {
StandIn* current = nullptr;
}

StandIn* currentStandIn() {
    return current;
}

StandIn::StandIn() : scenes(VCT_SOURCE_DIR "/assets") {}

StandIn::~StandIn() {
    std::free(glue.savedState);
}

void StandIn::event(std::function<void()> what) {
    script_.push_back([this, what = std::move(what)] { pending_ = what; });
}

void StandIn::command(int command) {
    event([this, command] { deliver(command); });
}

void StandIn::window(int width, int height) {
    event([this, width, height] {
        windows_.push_back(std::make_unique<ANativeWindow>(ANativeWindow{width, height, true}));
        glue.window = windows_.back().get();
        deliver(APP_CMD_INIT_WINDOW);
    });
}

void StandIn::loseWindow() {
    event([this] { takeWindow(); });
}

void StandIn::takeWindow() {
    if (glue.window == nullptr) return;
    deliver(APP_CMD_TERM_WINDOW);
    // The system frees it as soon as the app has answered.
    glue.window->alive = false;
    glue.window = nullptr;
}

void StandIn::resize(int width, int height) {
    event([this, width, height] {
        if (glue.window == nullptr) return;
        glue.window->width = width;
        glue.window->height = height;
        deliver(APP_CMD_CONFIG_CHANGED);
        deliver(APP_CMD_WINDOW_RESIZED);
        deliver(APP_CMD_CONTENT_RECT_CHANGED);
        deliver(APP_CMD_WINDOW_REDRAW_NEEDED);
    });
}

void StandIn::setDensity(int dpi) {
    event([this, dpi] {
        configuration_.density = dpi;
        deliver(APP_CMD_CONFIG_CHANGED);
    });
}

void StandIn::frames(int count) {
    script_.push_back([this, count] { framesLeft_ = count; });
}

void StandIn::framesUntilLogged(const std::string& text, int most) {
    script_.push_back([this, text, most] {
        untilLogged_ = text;
        framesLeft_ = most;
    });
}

void StandIn::input(AInputEvent input) {
    event([this, input]() mutable {
        timeNs_ += 16'000'000;
        input.timeNs = timeNs_;
        glue.onInputEvent(&glue, &input);
    });
}

void StandIn::start(int width, int height) {
    command(APP_CMD_START);
    command(APP_CMD_RESUME);
    window(width, height);
    command(APP_CMD_GAINED_FOCUS);
}

void StandIn::startUntilSceneShown(int width, int height) {
    start(width, height);
    framesUntilLogged(" triangles");
    frames(2);
}

void StandIn::run() {
    current = this;
    app::passedSelfTest().reset();
    if (!testsDriver) app::passedSelfTest() = SelfTestResult{true, "by a test of the app"};
    activity_.externalDataPath = files.c_str();
    activity_.internalDataPath = "";
    activity_.assetManager = &assets_;
    configuration_.density = density;
    glue.activity = &activity_;
    glue.config = &configuration_;
    if (restored) {
        glue.savedState = std::malloc(1);
        glue.savedStateSize = 1;
    }
    source_ = {LOOPER_ID_MAIN, &glue, [](android_app*, android_poll_source*) { current->pending_(); }};
    android_main(&glue);
    if (traceDepth != 0) misuse.push_back("a trace section was not ended");
    current = nullptr;
}

// Delivers a command as native_app_glue does.
void StandIn::deliver(int command) {
    if (command == APP_CMD_DESTROY) glue.destroyRequested = 1;
    if (command == APP_CMD_SAVE_STATE) {
        std::free(glue.savedState);
        glue.savedState = nullptr;
    }
    if (glue.onAppCmd != nullptr) glue.onAppCmd(&glue, command);
}

int StandIn::poll(int timeoutMs, void** data) {
    while (true) {
        if (!untilLogged_.empty() && logged(untilLogged_)) {
            untilLogged_.clear();
            framesLeft_ = 0;
        }
        // An app that asks for no refresh draws nothing until the next event of the script wakes it.
        if (framesLeft_ > 0 && timeoutMs == 0) return ALOOPER_POLL_TIMEOUT;
        if (framesLeft_ > 0 && atRefresh) {
            if (--framesLeft_ == 0 && !untilLogged_.empty()) {
                misuse.push_back("never logged: " + untilLogged_);
                untilLogged_.clear();
            }
            timeNs_ += refreshNs;
            const auto callback = std::exchange(atRefresh, nullptr);
            callback(timeNs_);
            return ALOOPER_POLL_CALLBACK;
        }
        framesLeft_ = 0;
        untilLogged_.clear();
        pending_ = nullptr;
        if (script_.empty()) {
            pending_ = [this] {
                if (glue.window != nullptr) deliver(APP_CMD_PAUSE);
                takeWindow();
                deliver(APP_CMD_STOP);
                deliver(APP_CMD_DESTROY);
            };
        } else {
            const std::function<void()> next = std::move(script_.front());
            script_.pop_front();
            next();
        }
        if (!pending_) continue;
        *data = &source_;
        return LOOPER_ID_MAIN;
    }
}

bool StandIn::logged(const std::string& text) const {
    return std::any_of(log.begin(), log.end(),
                       [&](const LogLine& line) { return line.text.find(text) != std::string::npos; });
}

std::string StandIn::errors() const {
    std::string text;
    for (const LogLine& line : log)
        if (line.priority >= 6) text += line.text + "\n";
    return text;
}

}  // namespace vct::test
