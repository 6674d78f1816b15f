// The viewer: draws a scene and the panel over it, and handles input. Read draw() in viewer.cpp first. It
// knows neither Android nor a desktop: the app (android/app.h) and `vct view` (desktop/window.h) provide the
// context to draw in, the fingers and the files.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gl_objects.h"
#include "app/hud.h"
#include "app/orbit_view.h"
#include "app/recording.h"
#include "app/resolution_scale.h"
#include "app/scenes.h"
#include "app/touch.h"
#include "lab/bench_run.h"
#include "lab/self_test.h"
#include "scene/near_plane.h"
#include "scene/scene_features.h"

namespace vct::app {

// The initial view of a scene, before the user changes anything.
struct ViewDefaults {
    std::optional<Camera> camera;  // fitted to the window; empty: OrbitView chooses it
    DirectionalLight light;
    // The scene's own sky. The user may replace it by a dark or a plain one.
    glm::vec3 skyRadiance{0.0F};
    std::shared_ptr<const Environment> environment;
    std::optional<glm::vec3> background;  // of the scene's own sky; see Settings
    std::optional<float> exposure;        // empty: chosen by the picture
    std::optional<int> grid;              // empty: as in Choices
    std::optional<int> cascades;          // empty: as in Choices
};

// A loaded scene, with what a thread computes from it before it is shown, because that takes seconds for
// millions of triangles.
struct PreparedScene {
    LoadedScene loaded;
    ViewDefaults look;
    std::optional<Camera> framed;  // a view of the whole scene; empty if the scene or the look has a camera
    SceneFeatures features;
    std::unique_ptr<const NearPlane> nearPlane;
    std::shared_ptr<const TriangleTree> obstacles;
};

// Services of the platform that the viewer runs on.
struct ViewerHost {
    std::string backend;       // driver.backend of timings.json
    std::string folder;        // folder for results; on Android also for the user's scenes
    float pixelsPerDp = 1.0F;  // screen density over 160 dpi
    gl::ReadShader shaders;
    // False: the first picture of a scene comes before the test of the driver, which is for drivers that
    // compile a program when it is linked. The test uses one program per frame for the first time.
    bool testsDriverFirst = true;
    FindFiles findScenes, findSkies;
    OpenFile openFile;
    std::function<void()> askForFile;  // shows a dialog whose file goes to Viewer::open(); empty on a phone
    std::function<void(bool)> keepScreenOn;
    // Returns how near the device is to severe throttling, which is at 1; empty if it does not tell.
    std::function<std::optional<float>()> thermalHeadroom = [] { return std::nullopt; };
    // Returns how to show a scene that was just loaded, in a window of `aspect`. `sky`: the picture beside
    // it, or null. Runs on a thread of its own. May throw vct::Error.
    std::function<ViewDefaults(const Scene&, const LoadedSky& sky, double aspect)> defaultsFor;
};

// The result of a self-test that passed in this process. A driver stays the same while a process runs, so
// neither a lost context nor another activity repeats the test.
std::optional<SelfTestResult>& passedSelfTest();

class Viewer {
  public:
    Viewer(ViewerHost host, const ShowRequest& request);
    ~Viewer();  // its context must be current
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    // Draws a frame into framebuffer 0 of the current context, `window` pixels in size. `free`: left, top,
    // right, bottom of the part that nothing covers (free_area.h). Throws gl::ContextLost, and vct::Error if
    // nothing can be drawn at all.
    void draw(glm::ivec2 window, const glm::ivec4& free);
    void shown() { ++shownFrames_; }  // must be called after the frame was shown

    // Destroy all GL objects, because the context was lost or because nothing can be drawn (`why`). The next
    // frame rebuilds them.
    void loseContext();
    void halt(const std::string& why);
    bool hasObjects() const { return gl_ != nullptr; }
    void dropRenderer();  // frees its memory; the next frame rebuilds it
    void dropCaches();    // frees what the picture does not need; another mode makes it again
    void resume() {
        lastFrame_ = std::chrono::steady_clock::now();
    }  // a pause does not advance the animation

    // `points`: every finger that is down after an event, in pixels from the top left.
    void finger(const std::vector<TouchPoint>& points, double timeS);
    void cancelTouch() {
        touch_.cancel();
        hud_.cancelTouch();
    }
    bool hudCovers(const glm::vec2& position) const { return hud_.covers(position); }

    // The mouse wheel over the panel; positive clicks are upwards.
    void scrollHud(const glm::vec2& position, float clicks) { hud_.scroll(position, clicks); }

    // For keys, which can change the same choices as the panel.
    Choices& choices() { return choices_; }
    void toggleHud() { hud_.toggle(); }
    void showOtherScene(int step);       // the scene `step` places further in the list
    void open(const std::string& path);  // a scene or the picture of a sky, as the user asked
    void setPixelsPerDp(float pixelsPerDp);
    void reset();                          // resets view, sun and exposure
    void turnLight(const glm::vec2& deg);  // turns the sun around the vertical and upwards
    // Moves the camera to the right, up and back, in shares of the scene's size.
    void walk(const glm::dvec3& shares);

    void startMeasuring(const std::string& command);  // "bench ...", see lab/bench_run.h
    void fail(const std::string& message);            // shows the message in the panel and logs it

    // True if the first scene could not be loaded and there is no other.
    bool hasNothingToShow() const { return !scene_ && !isLoading() && !message_.empty(); }

    // The picture on the screen without the panel, and everything that it depends on.
    struct Seen {
        std::string path;  // path of the scene's file
        glm::ivec2 size;   // size of the picture
        Camera camera;
        DirectionalLight light;
        Settings settings;
        float exposure;
        std::optional<double> timeS;  // time of the scene's animation, if it has one
        std::string cameraOption;     // text for --camera
        std::string skyPath;          // of the picture of the sky, if one is shown that the user chose
        Image radiance;
    };
    std::optional<Seen> seen();  // empty if no scene is shown

  private:
    // If any of these changes, a picture that failed is tried again.
    struct Wanted {
        Choices choices;
        std::shared_ptr<const Scene> scene;
        glm::ivec2 window{0};
        bool operator==(const Wanted& other) const = default;
    };

    void drawMessage(glm::ivec2 window, const glm::ivec4& free);
    bool drawScene(glm::ivec2 window);  // returns true if it rendered a frame
    // Shows the renderer's last frame, if there is one, and the panel over it.
    void present(const Renderer* renderer, glm::ivec2 window, const glm::ivec4& free, double passedS);
    void drawHud(glm::ivec2 window, const glm::ivec4& free, double passedS);
    // Runs a part of a frame. Returns why it failed, or "". Throws gl::ContextLost if the context was lost,
    // even if the driver reported another error first.
    static std::string failureOf(const std::function<void()>& part);
    void revert(const std::string& why, glm::ivec2 window);

    glm::ivec2 sizeIn(glm::ivec2 window) const;    // size of the rendered picture
    Settings settingsOf(glm::ivec2 window) const;  // settings of the renderer
    void followTime(glm::ivec2 window, double workMs);
    void followHeat(glm::ivec2 window);
    void record(double frameMs, double workMs);
    void endRecording(const std::string& failure);  // "": it is complete
    void logSize(const std::string& limit, glm::ivec2 window) const;
    DirectionalLight light() const;  // the sun in the scene's rest pose, turned as chosen
    double sceneTimeS() const;
    float exposure() const;

    // These are defined in viewer_measuring.cpp.
    void testDriver();
    void measure();
    void endMeasuring(const std::string& failure);  // "": the measurement is complete

    bool isLoading() const { return scenes_.loading() || preparing_.valid(); }  // a scene
    std::string scenePath() const;  // path of the scene that is being loaded, or else is shown
    void choose(int scene);         // loads a scene of the list, as the user asked
    void followSky();               // loads the picture that was chosen, and takes it
    void showFrom(int camera);      // from a camera of the scene
    std::shared_ptr<const PreparedScene> takePreparedScene(glm::ivec2 window);  // null: none is ready
    void takeLoadedScene(glm::ivec2 window);
    void show(std::shared_ptr<const PreparedScene> prepared, const ViewDefaults& look, glm::ivec2 window);
    void startView();  // from the camera of the look

    ViewerHost host_;
    Scenes scenes_;
    SkyPictures skies_;
    LoadedSky sky_;                                  // Choices::skyPicture, once it is loaded
    std::string skyPath_;                            // of sky_
    std::shared_ptr<const PreparedScene> prepared_;  // the scene that is shown
    std::shared_ptr<const Scene> scene_;             // of prepared_
    ViewDefaults defaults_;                          // of prepared_, with the camera that the user chose
    std::optional<OrbitView> view_;
    int camera_ = 0;       // of the scene, that the user chose last
    double aspect_ = 1.0;  // aspect ratio of the last picture

    Choices choices_;
    ResolutionScale scale_;
    std::chrono::steady_clock::time_point nextHeatCheck_;
    std::optional<float> headroom_;  // as the device told last
    int recordS_;                    // seconds to record, once a scene is shown
    std::optional<Recording> recording_;
    double animationS_ = 0.0;                            // playing time so far, of all scenes together
    std::optional<Wanted> good_;                         // the last frame that could be rendered
    std::shared_ptr<const PreparedScene> goodPrepared_;  // its scene
    ViewDefaults goodDefaults_;                          // the look of that frame
    std::optional<Wanted> failed_;  // a frame that could not be rendered and is not tried again
    Exposure exposure_;             // used if the look has none
    std::size_t unlinked_ = 0;      // programs that the next frame of the scene waits for
    std::string message_;           // shown in the panel

    std::unique_ptr<SelfTest> selfTest_;        // while it runs; holds GL objects
    std::optional<SelfTestResult> testResult_;  // empty until the self-test is complete
    std::unique_ptr<ResultsFolder> results_;    // set during a measurement
    std::optional<BenchRequest> request_;       // set during a measurement, from before its scene is loaded
    std::unique_ptr<BenchRun> bench_;           // holds GL objects, as gl_ does
    int shownFrames_ = 0;

    Hud hud_;
    Touch touch_;
    bool touching_ = false, touchesHud_ = false;
    TouchPoint hudFinger_;

    std::unique_ptr<GlObjects> gl_;

    std::chrono::steady_clock::time_point lastFrame_;
    double frameMs_ = 0.0;
    std::optional<std::array<double, stepCount>> stepMs_;
    double presentMs_ = 0.0;  // of the last frame whose steps were timed

    std::future<std::shared_ptr<const PreparedScene>> preparing_;  // its thread uses host_
};

}  // namespace vct::app
