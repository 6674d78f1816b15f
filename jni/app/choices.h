// The choices in the panel, and the settings of the renderer that follow from them.
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

// A choice for the size of the rendered picture, which is then scaled to the window.
struct Resolution {
    const char* name;  // in the panel
    const char* word;  // in the text of a ShowRequest
    int divisor;       // the window's sides are divided by it; 0: see `fixed`
    glm::ivec2 fixed;  // fixed size, shown with its own aspect ratio; 0: ResolutionScale chooses the size
};
const std::vector<Resolution>& resolutions();

// The sky outside the scene.
enum class Sky {
    scene,  // the one that goes with the scene's sun, or dark if it has none (chooseSky())
    dark,
    plain,
    picture,  // Choices::skyPicture
};
// The skies that need no file.
const std::vector<Sky>& skies();
const char* skyName(Sky sky);  // "scene", "dark", "plain", "picture"

struct Choices {
    std::string preset = defaultPreset;
    Output mode = Output::giConeShadow;
    int grid = presetSettings(preset).grid;  // voxels per side
    std::optional<int> cascades;             // Settings::cascades; empty: cascadesFor() the scene
    float coneAngleDeg = 5.0F;
    int resolution = 0;  // index into resolutions()
    // Direction to the sun: degrees from +Z towards +X, and degrees above the horizon. Empty: as in the
    // scene.
    std::optional<glm::vec2> lightAnglesDeg;
    std::bitset<VCT_MAX_PUNCTUAL_LIGHTS> lightsOff;  // one bit per light of Scene::punctualLights
    Sky sky = Sky::scene;
    std::string skyPicture;  // name or path of a .hdr file, for Sky::picture
    bool timeSteps = true;
    bool play = true;  // play the scene's animation
    bool revoxelize = false;

    bool operator==(const Choices& other) const = default;
};

// The first scene and choices. As text: "show scene=cornell.glb preset=thesis mode=gi grid=64
// cascades=auto cone-angle=5 pixels=1 display=off steps=off time=1.5 revoxelize=on sky=plain lights-off=1,3".
// `sky` may also be the name of a .hdr file.
// Each word but the first may be left out. `pixels` is auto, a divisor of the window's sides from 1 to 4, or
// thesis; `time` stops the animation at this second; `lights-off` has the numbers of lights besides the sun,
// counted from 1.
struct ShowRequest {
    std::string scene;
    Choices choices;
    bool display = true;
    double timeS = 0.0;
    int recordS = 0;  // seconds for which the time of each frame is recorded; 0: not at all
};
// Throws vct::Error.
ShowRequest showRequestFromText(const std::string& text);

// Chooses a preset, its grid and the number of cascades by the scene: presets differ so much in memory per
// voxel that a grid that fits with one may not fit with another. Throws vct::Error.
void choosePreset(Choices& choices, const std::string& name);

// True if the size of the picture follows the time that frames take.
bool scaleFollowsTime(const Choices& choices);

// The number of cascades that `settings` need so that voxels around the camera are at most 25 cm, about as
// thick as walls; or as many as there may be. 1 for packed voxels.
int cascadesFor(const Scene& scene, const Settings& settings);

// The renderer's settings, except for the sky, and with one cascade if `choices` leave their number to the
// scene. `divisor` divides the window's sides if the size follows the
// time.
Settings settingsFor(const Choices& choices, glm::ivec2 window, double divisor);

// The sky's radiance: `sceneSky` if the scene's own sky was chosen, or a picture, until it is loaded; 0; or a
// plain sky that suits `light`.
glm::vec3 skyRadianceFor(const Choices& choices, const glm::vec3& sceneSky, const DirectionalLight& light);

// The scene's sun `light`, turned to the chosen direction.
DirectionalLight lightFor(const Choices& choices, DirectionalLight light);
// The direction to the light, as in Choices::lightAnglesDeg.
glm::vec2 lightAnglesDeg(const DirectionalLight& light);

}  // namespace vct::app
