// What the display lets a person change, and what it means for the renderer.
#pragma once

#include <bitset>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/output.h"
#include "engine/settings.h"
#include "scene/scene.h"

namespace vct::app {

// The pixels that are rendered, which the window then shows larger.
struct Resolution {
    const char* name;
    const char* word;  // as in ShowRequest
    int divisor;       // of the window's sides; 0: `fixed`, or where that is 0 too, ResolutionScale's
    glm::ivec2 fixed;  // keeps its shape
};
const std::vector<Resolution>& resolutions();

// What is outside the scene.
enum class Sky {
    scene,  // dark, but a plain sky around a scene in which nothing shines (scene/camera.h)
    dark,
    plain,
};
const std::vector<Sky>& skies();
const char* skyName(Sky sky);  // "scene", "dark", "plain"

struct Choices {
    std::string preset = defaultPreset;
    Output mode = Output::giConeShadow;
    int grid = presetSettings(preset).grid;  // voxels along a side
    float coneAngleDeg = 5.0F;
    int resolution = 0;  // index into resolutions()
    // Where the light comes from: degrees from +Z towards +X, and above the horizon. Empty: as in the scene.
    std::optional<glm::vec2> lightAnglesDeg;
    std::bitset<VCT_MAX_PUNCTUAL_LIGHTS> lightsOff;  // of Scene::punctualLights
    Sky sky = Sky::scene;
    bool timeSteps = true;
    bool play = true;  // the scene's animation; else it stands still
    bool revoxelize = false;

    bool operator==(const Choices& other) const = default;
};

// What to begin with: "show scene=cornell.glb preset=thesis mode=gi grid=64 cone-angle=5 pixels=1 display=off
// steps=off time=1.5 revoxelize=on sky=plain lights-off=1,3", each but the first word may be left out;
// pixels: auto, 1 to 4, the divisor of the window's sides, or thesis; time: where the animation stands still,
// in seconds; lights-off: which of the lights besides the sun, counted from 1.
struct ShowRequest {
    std::string scene;
    Choices choices;
    bool display = true;
    double timeS = 0.0;
};
// Throws vct::Error.
ShowRequest showRequestFromText(const std::string& text);

// With the preset's own grid: six faces per voxel take six times the memory of a word. Throws
// vct::Error.
void choosePreset(Choices& choices, const std::string& name);

// Whether the size of pictures follows the time that they take.
bool scaleFollowsTime(const Choices& choices);

// But for the sky. `divisor`: of the window's sides, for a size that follows the time.
Settings settingsFor(const Choices& choices, glm::ivec2 window, double divisor);

// The sky's radiance: `sceneSky` where the scene's own was chosen; a plain sky is as of `light`.
glm::vec3 skyRadianceFor(const Choices& choices, const glm::vec3& sceneSky, const DirectionalLight& light);

// A scene's light, turned to where it was chosen to come from.
DirectionalLight lightFor(const Choices& choices, DirectionalLight light);
glm::vec2 lightAnglesDeg(const DirectionalLight& light);

}  // namespace vct::app
