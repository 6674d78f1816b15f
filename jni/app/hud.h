// The panel: shows times and messages, and changes the choices by touch. Knows nothing of GL or Android.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/choices.h"
#include "app/scenes.h"
#include "engine/step_timer.h"

struct ImDrawData;
struct ImGuiContext;
struct ImGuiWindow;

namespace vct::app {

// Content of the panel. The user changes `choices` and `scene`.
struct HudContent {
    Choices* choices = nullptr;
    int* scene = nullptr;  // index into scenes, or -1
    const std::vector<FileChoice>* scenes = nullptr;
    const std::vector<FileChoice>* skies = nullptr;         // pictures of skies
    std::vector<std::string> cameras;                       // names of the scene's cameras
    int camera = 0;                                         // the one that was chosen last
    bool opensFiles = false;                                // the host can ask the user for a file
    glm::vec2 sceneLightDeg{0.0F};                          // direction to the scene's sun
    double frameMs = 0.0;                                   // time between two frames on the screen
    const std::array<double, stepCount>* stepMs = nullptr;  // time of each step; null: not timed
    double presentMs = 0.0;         // time to show the last frame and this panel; used with stepMs
    glm::ivec2 renderSize{0};       // pixels
    std::optional<double> divisor;  // divisor of the window's sides, if the size follows the time
    bool isLimitedByHeat = false;   // the size would be larger if the device were cooler
    std::function<std::vector<int>()> possibleGrids;  // grids that driver and free memory allow now
    int cascades = 1;                                 // of the picture
    bool animated = false;                            // the scene has an animation
    std::vector<std::string> lights;                  // names of the scene's lights besides the sun
    std::string status;                               // current activity: loading, measuring
    std::string message;                              // last error or result
    bool measuring = false;
};

struct HudActions {
    bool resetView = false;
    bool rescan = false;
    bool openFile = false;
    std::optional<int> camera;  // the user chose it
    bool measure = false;       // start a measurement, or stop the running one
    bool dismiss = false;       // remove the message
};

class Hud {
  public:
    // `pixelsPerDp`: screen density over 160 dpi.
    explicit Hud(float pixelsPerDp);
    ~Hud();
    Hud(const Hud&) = delete;
    Hud& operator=(const Hud&) = delete;

    // Another density, as when a phone is unfolded or a window moves to another display.
    void setPixelsPerDp(float pixelsPerDp);

    // True if the panel covered this position when it was last drawn.
    bool covers(const glm::vec2& position) const;
    // Reports one finger, which touched the screen first at a position that covers() accepted. Pixels from
    // the top left. A finger that first moves up or down scrolls the panel or list below it. Otherwise the
    // widget below it is pressed, once the finger moves sideways or is lifted.
    void touch(const glm::vec2& position, bool down);
    // Drops the finger, because the system has taken it for a gesture of its own.
    void cancelTouch();
    // Reports the mouse wheel; positive clicks are upwards.
    void scroll(const glm::vec2& position, float clicks);

    // `free`: left, top, right, bottom of the window's part that nothing covers (free_area.h).
    HudActions build(const HudContent& content, glm::ivec2 window, const glm::ivec4& free,
                     double secondsPassed);
    // Builds one message over the whole width of the window, instead of the panel.
    void buildMessage(const std::string& title, const std::string& text, glm::ivec2 window,
                      const glm::ivec4& free);
    // Triangles of the last build.
    const ImDrawData& drawData() const;

    void turnOff() { off_ = true; }  // draws nothing at all
    // Folds or unfolds the panel. A folded panel is a button that unfolds it, with messages. Until the user
    // has chosen, it is folded where it would cover more than a quarter of the window's width.
    void toggle() { folded_ = !isFolded_; }

  private:
    void beginFrame(glm::ivec2 window, const glm::ivec4& free, double secondsPassed);
    void endFrame();
    void beginPanel(const char* name, const glm::ivec4& free, float widest);
    void buildTimes(const HudContent& content) const;
    void buildChoices(const HudContent& content, HudActions& actions) const;
    void buildGrid(const HudContent& content) const;
    void buildCascades(const HudContent& content) const;
    void buildLight(const HudContent& content) const;
    void buildLights(const HudContent& content) const;
    void buildCameras(const HudContent& content, HudActions& actions) const;
    void buildSky(const HudContent& content, HudActions& actions) const;
    void setScale(float pixelsPerDp);
    ImGuiWindow* scrollableAt(const glm::vec2& position) const;

    ImGuiContext* context_;
    float scale_ = 1.0F;
    float slop_ = 8.0F;           // pixels that a finger moves before it counts as moving
    std::optional<bool> folded_;  // as the user chose
    bool isFolded_ = false;       // in the last frame
    bool off_ = false;
    struct TouchEvent {
        glm::vec2 position;
        bool down;
    };
    std::deque<TouchEvent> touches_;  // of the widgets
    // The finger. While it is undecided, the widgets do not know of it.
    enum class Finger { up, undecided, scrolls, presses } finger_ = Finger::up;
    glm::vec2 fingerStart_{0.0F};
    ImGuiWindow* scrolled_ = nullptr;  // the panel or list that the finger scrolls
    float scrollStart_ = 0.0F;
    glm::vec2 wheelAt_{0.0F};
    float wheelClicks_ = 0.0F;  // since the last frame
    bool touchDown_ = false;
};

}  // namespace vct::app
