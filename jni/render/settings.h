// What a frame is asked to be. A preset is a set of settings, not a second renderer.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "shared/layout.h"

namespace vct {

// The thesis's five scenes (5.1.2); the numbers are those of shaders/shared/layout.h.
enum class Mode {
    phong = VCT_MODE_PHONG,                  // Phong, diffuse and specular, no shadow
    shadowMap = VCT_MODE_SHADOW_MAP,         // and the shadow map
    ao = VCT_MODE_AO,                        // and cone-traced ambient occlusion
    gi = VCT_MODE_GI,                        // and a diffuse bounce
    giConeShadow = VCT_MODE_GI_CONE_SHADOW,  // the shadow cone in place of the shadow map
};

const std::vector<Mode>& allModes();
const char* modeName(Mode mode);  // "phong", "shadow-map", "ao", "gi", "gi-cone-shadow"
// "all", or names and numbers separated by commas; throws vct::Error listing the names.
std::vector<Mode> modesFromText(const std::string& text);

// Single changes to the thesis's algorithm, for measuring what each of its known defects costs
// (docs/defects.md). None is part of a preset. `define` is what the shaders see.
struct Experiment {
    const char* name;
    const char* define;
    const char* what;
};
const std::vector<Experiment>& allExperiments();

// What makes the soft shadow of mode 5.
enum class Shadow {
    cone,     // a cone through the voxels (thesis 4.6)
    softMap,  // percentage-closer filtering of the shadow map (shaders/shared/soft_shadow.glsl)
};
const char* shadowName(Shadow shadow);  // "cone", "soft-map"
// Throws vct::Error listing the names.
Shadow shadowFromText(const std::string& text);

struct Settings {
    Mode mode = Mode::giConeShadow;
    int grid = 256;                        // voxels along a side of the volume: 64, 128, 256 or 512
    glm::ivec2 size{400, 400};             // pixels
    int shadowMapSize = 512;               // texels along a side
    float shadowConeAngleDeg = 5.0F;       // full opening angle of the cone towards the light
    Shadow shadow = Shadow::cone;          // of mode 5
    int blockerTaps = 8;                   // of softMap: texels read in search of what blocks the sun
    int filterTaps = 16;                   // of softMap: comparisons in a penumbra
    float aoDistance = 0.045F;             // of the volume's side
    glm::vec3 skyRadiance{0.0F};           // seen by cones and pixels that leave the volume
    std::vector<std::string> experiments;  // names out of allExperiments()
    bool emulateHalf = false;              // round the shaders' mediump values to 16 bits, as Mali does
    std::uint32_t activeVoxelLimit = 0;    // capacity of the active-voxel list's base level; 0: by the grid
};

const std::vector<std::string>& presetNames();
// Throws vct::Error listing the presets.
Settings presetSettings(const std::string& name);

// Throws vct::Error where a value is outside what the pipeline can do.
void validate(const Settings& settings);

}  // namespace vct
