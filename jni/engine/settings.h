// The settings of a renderer. A preset is a set of settings, not a second renderer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

namespace vct {

class Environment;

// The way in which mode 5 finds the soft shadow.
enum class Shadow {
    cone,     // a cone through the voxels (thesis 4.6)
    softMap,  // percentage-closer filtering of the shadow map (shaders/passes/soft_shadow.glsl)
};
const char* shadowName(Shadow shadow);  // "cone", "soft-map"
// Throws vct::Error listing the names.
Shadow shadowFromText(const std::string& text);

// The light that glossy materials (roughness below 1) reflect besides diffuse light.
enum class Specular {
    none,  // nothing: every surface is a Lambert one of its base colour
    cone,  // the sun, and one cone along the mirror direction (shaders/passes/glossy.glsl)
};
const char* specularName(Specular specular);  // "none", "cone"
// Throws vct::Error listing the names.
Specular specularFromText(const std::string& text);

// The kind of voxels that cones are traced through.
enum class Voxels {
    packed,       // the thesis's: one packed word per voxel, filtered by hand
    directional,  // directional coverage: six faces per voxel, filtered by the texture unit
};

// The purpose of a gather: all light, or ambient visibility within the AO distance.
enum class GatherPurpose { light, occlusion };

// A gather through the faces of directional coverage voxels. Lengths in voxels of the finest level. Measured
// in docs/levers.md.
struct GatherSettings {
    int directions = 64;  // per face, visited over several frames while the light settles, a power of two
    int refinedDirections = 0;  // per face, visited once the light has settled, a power of two; 0: none
    int cones = 8;              // per face and frame in which nothing changed, until the light has converged
    // Per frame in which something changes, whatever the scene: faces take turns, those that pixels look up
    // most often.
    int coneBudget = 16384;
    float startOffset = 0.5F;  // along the normal
    float firstSample = 0.5F;  // along the cone
    // Height above the surface's plane, in footprints, up to which its own faces, which look against the cone
    // where the surface is slanted, are not met. They are within half a texel of it, filtered by one more.
    float ownSurface = 1.5F;
    float step = 1.25F;        // between samples, in footprints
    float height = 0.5F;       // largest footprint, of the sample's height above the surface's plane
    float extinction = 1.05F;  // scales the opacity of a sample
    // Of the last sample before the footprint grows, in shares of its opacity: .5 is exact where all is
    // covered in part, 1 lets nothing through a wall that stands there (docs/levers.md).
    float levelEnd = 0.65F;
    // Whether what stands on the volume's border fades into the nothing behind it, or cones are cut off
    // there, which loses some of it and hides that cones meet too much elsewhere (docs/levers.md).
    bool fadesAtBorder = false;
    float threshold = 0.15F;  // a cone with less transmittance left is done
    // Scales what faces send on: cones lose some light through the gaps between their samples (a closed
    // furnace shows it), and each bounce would lose it again.
    float bounceGain = 1.06F;

    // The number of directions to choose from.
    int directionSet() const { return std::max(directions, refinedDirections); }
};

// What a face received in k steps is a mean in which each step's share is this over (k + this): 1 would be
// the plain mean, which never forgets the first steps, that knew no bounces.
constexpr float recentStepWeight = 6.0F;

// The grids among which one is chosen by the scene (grid_choice.h), both included.
struct GridRange {
    int coarsest = 64;
    int finest = 512;
};

struct Settings {
    Voxels voxels = Voxels::packed;
    Specular specular = Specular::none;  // of modes 4 and 5, where voxels are faces
    GatherSettings gather;               // of diffuse light, where voxels are faces
    GatherSettings occlusion;            // of ambient occlusion alone (mode 3), likewise
    int lightFrames = 16;                // after a change, until the light has settled; refinement may follow
    int grid = 256;                      // voxels along a side of the volume, one of allGrids()
    GridRange gridRange;                 // for a grid that follows from the scene
    glm::ivec2 size{400, 400};           // pixels
    int shadowMapSize = 512;             // texels along a side
    float shadowConeAngleDeg = 5.0F;     // full opening angle of the cone towards the light
    float lightRadius = 0.0F;      // of points and spots in mode 5, in the scene's unit; 0: hard shadows
    Shadow shadow = Shadow::cone;  // of mode 5
    int filterTaps = 8;            // of softMap: places in a penumbra; a multiple of 4
    float aoDistance = 0.045F;     // of the volume's side
    glm::vec3 skyRadiance{0.0F};   // seen by cones and pixels that leave the volume
    // In place of skyRadiance: a picture of all directions, in the scene's unit of radiance.
    std::shared_ptr<const Environment> environment;
    bool revoxelize = false;             // rebuild shadow map and voxels in every frame, to measure that
    bool countInvocations = false;       // count what runs (shaders/shared/counters.glsl); slow
    std::uint32_t activeVoxelLimit = 0;  // capacity of the active-voxel list's base level; 0: by the grid
};

const std::vector<int>& allGrids();  // 64, 128, 256, 512

// The preset where none is named: seconds on a CPU, milliseconds on a phone.
constexpr const char* defaultPreset = "mobile";
const std::vector<std::string>& presetNames();
std::string presetList();  // with commas
// Throws vct::Error listing the presets.
Settings presetSettings(const std::string& name);

// Throws vct::Error where a value is outside what the pipeline can do.
void validate(const Settings& settings);

}  // namespace vct
