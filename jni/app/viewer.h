// A scene in a window, with the display over it, between two events: what it was told, what it holds, and its
// frame. Read draw() in viewer.cpp first. It knows neither Android nor a desktop: the app (android/app.h) and
// `vct view` (desktop/window.h) give it a context to draw in, fingers, and files.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gl_objects.h"
#include "app/hud.h"
#include "app/orbit_view.h"
#include "app/resolution_scale.h"
#include "app/scenes.h"
#include "app/touch.h"
#include "lab/bench_run.h"
#include "lab/self_test.h"

namespace vct::app {

// How a scene is shown before anybody touches anything.
struct ViewDefaults {
    std::optional<Camera> camera;  // for the window's shape; else OrbitView's
    DirectionalLight light;
    // The scene's own sky, which may be replaced by a dark or a plain one.
    glm::vec3 skyRadiance{0.0F};
    std::shared_ptr<const Environment> environment;
    std::optional<float> exposure;  // else by the picture
    std::optional<int> grid;        // else as chosen
};

// What a viewer asks of where it runs.
struct ViewerHost {
    std::string backend;       // driver.backend of timings.json
    std::string folder;        // of what is measured; the person's scenes are there too
    float pixelsPerDp = 1.0F;  // screen density over 160 dpi
    gl::ReadShader shaders;
    FindScenes findScenes;
    ReadScene readScene;
    std::function<void(bool)> keepScreenOn;
    // Of a scene that was just loaded, for a window of `aspect`. May throw vct::Error.
    std::function<ViewDefaults(const Scene&, double aspect)> defaultsFor;
};

class Viewer {
  public:
    Viewer(ViewerHost host, const ShowRequest& request);
    ~Viewer();  // in its context
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    // A frame into the context's framebuffer 0, `window` pixels in size; `free`: left, top, right, bottom of
    // the part that nothing covers. Throws gl::ContextLost, and vct::Error where nothing can be drawn at all.
    void draw(glm::ivec2 window, const glm::ivec4& free);
    void shown() { ++shownFrames_; }

    // Everything in the context goes, as it was lost, or as nothing can be drawn (`why`); the next frame
    // makes it anew.
    void loseContext();
    void halt(const std::string& why);
    bool hasObjects() const { return gl_ != nullptr; }
    void dropRenderer();  // memory is short, and nothing is on the screen
    void resume() { lastFrame_ = std::chrono::steady_clock::now(); }

    // Every finger that is down after an event, in pixels from the top left.
    void finger(const std::vector<TouchPoint>& points, double timeS);
    void cancelTouch() { touch_.cancel(); }
    bool hudCovers(const glm::vec2& position) const { return hud_.covers(position); }

    // The mouse's wheel over the display; clicks upwards.
    void scrollHud(const glm::vec2& position, float clicks) { hud_.scroll(position, clicks); }

    // What fingers choose in the display can be chosen by keys, too.
    Choices& choices() { return choices_; }
    void toggleHud() { hud_.toggle(); }
    void showOtherScene(int step);         // of the list
    void reset();                          // view, light and exposure
    void turnLight(const glm::vec2& deg);  // around, and up
    // Right, up and back, in shares of the scene's size.
    void walk(const glm::dvec3& shares);

    void startMeasuring(const std::string& command);  // "bench ...", lab/bench_run.h
    void fail(const std::string& message);            // shows it, and logs it

    // Whether the scene that it began with could not be loaded, and no other is there.
    bool hasNothingToShow() const { return !scene_ && !scenes_.loading() && !message_.empty(); }

    // What is on the screen, but for the display. Nothing where no scene is shown.
    struct Seen {
        std::string path;  // of the scene's file
        glm::ivec2 size;   // of the picture
        Camera camera;
        DirectionalLight light;
        Settings settings;
        float exposure;
        std::optional<double> timeS;  // of the scene's animation
        std::string cameraOption;
        Image radiance;
    };
    std::optional<Seen> seen();

  private:
    // What a picture depends on that needs another renderer, or another try.
    struct Wanted {
        Choices choices;
        std::shared_ptr<const Scene> scene;
        glm::ivec2 window{0};
        bool operator==(const Wanted& other) const = default;
    };

    void drawMessage(glm::ivec2 window, const glm::ivec4& free);
    void drawScene(glm::ivec2 window);
    void drawHud(glm::ivec2 window, const glm::ivec4& free, double passedS);
    // Runs a part of a frame; returns why it failed, or "". Throws gl::ContextLost where that is the reason:
    // a driver that has lost the context may complain of anything first.
    static std::string failureOf(const std::function<void()>& part);
    void revert(const std::string& why, glm::ivec2 window);

    glm::ivec2 sizeIn(glm::ivec2 window) const;    // of pictures
    Settings settingsOf(glm::ivec2 window) const;  // of the scene
    void followTime(glm::ivec2 window, std::chrono::steady_clock::time_point start);
    DirectionalLight light() const;  // at rest
    double sceneTimeS() const;
    float exposure() const;

    // In viewer_measuring.cpp.
    void testDriver();
    void measure();
    void endMeasuring(const std::string& failure);  // "": all is written

    std::string scenePath() const;  // of what is being loaded or shown
    void takeLoadedScene(glm::ivec2 window);
    void show(std::shared_ptr<const Scene> scene, const ViewDefaults& look, glm::ivec2 window);

    ViewerHost host_;
    Scenes scenes_;
    std::shared_ptr<const Scene> scene_;
    ViewDefaults defaults_;
    std::optional<OrbitView> view_;
    double aspect_ = 1.0;  // of the last picture

    Choices choices_;
    ResolutionScale scale_;
    double animationS_ = 0.0;       // what has been played, of any scene
    std::optional<Wanted> good_;    // of the last frame that could be rendered
    ViewDefaults goodDefaults_;     // likewise
    std::optional<Wanted> failed_;  // could not be rendered, and is not tried again
    Exposure exposure_;             // unless the look has one
    std::string message_;

    std::optional<SelfTest> selfTest_;
    std::unique_ptr<ResultsFolder> results_;  // while something is measured
    std::optional<BenchRequest> request_;     // what is to be measured once its scene is there
    std::unique_ptr<BenchRun> bench_;         // in the context, as gl_
    int shownFrames_ = 0;

    Hud hud_;
    Touch touch_;
    bool touching_ = false, touchesHud_ = false;
    TouchPoint hudFinger_;

    std::unique_ptr<GlObjects> gl_;

    std::chrono::steady_clock::time_point lastFrame_;
    double frameMs_ = 0.0;
    std::optional<std::array<double, stepCount>> stepMs_;
};

}  // namespace vct::app
