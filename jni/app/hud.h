// The head-up display: what is measured, and what can be changed, by touch. Knows nothing of GL or Android.
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

namespace vct::app {

// What is shown. `choices` and `scene` are changed by the person.
struct HudContent {
    Choices* choices = nullptr;
    int* scene = nullptr;  // index into scenes, or -1
    const std::vector<SceneFile>* scenes = nullptr;
    glm::vec2 sceneLightDeg{0.0F};                          // where the scene's light comes from
    double frameMs = 0.0;                                   // between two frames on the screen
    const std::array<double, stepCount>* stepMs = nullptr;  // null: not timed
    glm::ivec2 renderSize{0};
    std::optional<double> divisor;                    // of the window's sides, where it follows the time
    std::function<std::vector<int>()> possibleGrids;  // of the scene and the driver, now
    bool animated = false;                            // the scene
    std::vector<std::string> lights;                  // of the scene besides the sun, by name
    std::string status;                               // what is going on: loading, measuring
    std::string message;                              // what went wrong
    bool measuring = false;
};

struct HudActions {
    bool resetView = false;
    bool rescan = false;
    bool measure = false;  // start, or stop where one is going on
    bool dismiss = false;  // the message has been read
};

class Hud {
  public:
    // `pixelsPerDp`: screen density over 160 dpi.
    explicit Hud(float pixelsPerDp);
    ~Hud();
    Hud(const Hud&) = delete;
    Hud& operator=(const Hud&) = delete;

    // Whether a finger put down there is meant for the display, as it was last drawn.
    bool covers(const glm::vec2& position) const;
    // One finger, that began where covers() said so; pixels from the top left.
    void touch(const glm::vec2& position, bool down);
    // The mouse's wheel; clicks upwards.
    void scroll(const glm::vec2& position, float clicks);

    // `free`: left, top, right, bottom of the window's part that no system bar covers.
    HudActions build(const HudContent& content, glm::ivec2 window, const glm::ivec4& free,
                     double secondsPassed);
    // One message over all of the window, instead of the display.
    void buildMessage(const std::string& title, const std::string& text, glm::ivec2 window,
                      const glm::ivec4& free);
    // Of the last build.
    const ImDrawData& drawData() const;

    // A hidden display is only a button; without one there is not even that.
    void turnOff() { off_ = true; }
    void toggle() { hidden_ = !hidden_; }

  private:
    void beginFrame(glm::ivec2 window, double secondsPassed);
    void endFrame();
    void beginPanel(const char* name, const glm::ivec4& free, float widest);
    void buildTimes(const HudContent& content) const;
    void buildChoices(const HudContent& content, HudActions& actions) const;
    void buildGrid(const HudContent& content) const;
    void buildLight(const HudContent& content) const;
    void buildLights(const HudContent& content) const;
    void scrollByTouch() const;

    ImGuiContext* context_;
    float scale_;
    bool hidden_ = false, off_ = false;
    struct TouchEvent {
        glm::vec2 position;
        bool down;
    };
    std::deque<TouchEvent> touches_;
    glm::vec2 wheelAt_{0.0F};
    float wheelClicks_ = 0.0F;  // since the last frame
    bool touchDown_ = false;
};

}  // namespace vct::app
