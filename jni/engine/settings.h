// The settings of a renderer, and the presets. A preset is a set of settings, not a second renderer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vct {

class Environment;

// The kind of voxels, and with it the kind of light.
enum class Voxels {
    // The thesis's: one packed word per voxel. Each pixel traces cones for indirect light and soft
    // shadow, and every surface is Lambertian.
    packed,
    // Six one-sided faces per voxel, which gather light. The soft shadow is of the shadow map, and glossy
    // materials reflect.
    directional,
};

// Settings of the gather at the faces of directional voxels. docs/design-decisions.md has the measurements
// behind the values.
struct GatherSettings {
    int directions = 64;        // cached rays per face; a power of two
    int refinedDirections = 0;  // rays per face that refine the light at rest; a power of two; 0: none
    int hitBits = 20;           // per cached ray: 24 if half a million ids of faces do not suffice
    int rays = 8;               // rays per face and light step, of those that are new and that refine
    // Rays of all faces of moving objects together that are traced again in a frame in which one moves.
    int rayBudget = 32768;

    // The number of directions to choose from.
    int directionSet() const { return std::max(directions, refinedDirections); }
};

// The coarsest and the finest grid that chooseGrid() may choose (grid_choice.h).
struct GridRange {
    int coarsest = 64;
    int finest = 512;
};

struct Settings {
    Voxels voxels = Voxels::packed;
    GatherSettings gather;            // indirect diffuse light; directional voxels only
    int lightFrames = 16;             // light steps after a change; refinement may follow them
    int grid = 256;                   // voxels along a side of the volume, one of allGrids()
    GridRange gridRange;              // bounds for chooseGrid()
    int cascades = 1;                 // nested cubes of `grid` voxels (cascades.h); directional voxels only
    glm::ivec2 size{400, 400};        // pixels
    int shadowMapSize = 512;          // texels along a side
    float shadowConeAngleDeg = 5.0F;  // full opening angle of the sun's disc
    float lightRadius = 0.0F;         // metres, of point and spot lights in mode 5; 0: hard shadows
    float aoDistance = 0.045F;        // relative to the volume's side
    glm::vec3 skyRadiance{0.0F};      // light from outside of the volume; the scene's radiance unit
    // A sky that depends on direction, in the scene's radiance unit. It replaces skyRadiance.
    std::shared_ptr<const Environment> environment;
    // Radiance behind the scene, without effect on its light; empty: the sky's. For skies of one colour.
    std::optional<glm::vec3> background;
    bool revoxelize = false;             // rebuild shadow maps and voxels in every frame, to measure that
    std::uint32_t activeVoxelLimit = 0;  // capacity of the base level's active-voxel list; 0: by the grid

    // The gather's settings in frames. Hits are kept for a few frames only, if all surfaces are rebuilt in
    // each, so there are fewer.
    GatherSettings gatherOfFrames() const;
};

const std::vector<int>& allGrids();  // 64, 128, 256, 512
int maxCascadesFor(int grid);        // bound of Settings::cascades

// The preset if none is named: a picture takes seconds on a CPU, a frame takes milliseconds on a phone.
constexpr const char* defaultPreset = "mobile";
const std::vector<std::string>& presetNames();
std::string presetList();  // separated by commas
// Throws vct::Error that lists the presets if `name` is none of them.
Settings presetSettings(const std::string& name);

// Throws vct::Error that names the first setting that is out of range.
void validate(const Settings& settings);

}  // namespace vct
