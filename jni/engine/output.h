// The outputs that a frame can produce, and the inputs that each of them needs.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "shared/layout.h"

namespace vct {

enum class Output {
    // The five modes are the thesis's (5.1.2). Each adds to the one before, up to `gi`.
    phong = VCT_MODE_PHONG,                  // Phong shading, diffuse and specular, no shadow
    shadowMap = VCT_MODE_SHADOW_MAP,         // adds the shadow map
    ao = VCT_MODE_AO,                        // adds ambient occlusion
    gi = VCT_MODE_GI,                        // adds a bounce of diffuse light
    giConeShadow = VCT_MODE_GI_CONE_SHADOW,  // `gi` with a soft shadow in place of the shadow map's
    // Parts of the light, each alone.
    ambientVisibility = VCT_VIEW_AO,
    indirectLight = VCT_VIEW_INDIRECT,
    sunVisibility = VCT_VIEW_CONE_SHADOW,
    irradiance = VCT_VIEW_IRRADIANCE,  // irradiance by the indirect light, relative to the sun's
    specularLight = VCT_VIEW_SPECULAR,
};

struct OutputReads {
    Output output;
    const char* name;  // also names the output's files
    bool hardShadow;   // the shadow map with hard edges
    bool softShadow;   // the visible share of the sun's disc
    bool voxels;
    bool ambientVisibility;
    bool indirectLight;
    bool reflections;  // the voxels along the mirror direction, and the G-buffer's gloss
    bool emission;     // the G-buffer's emission
    bool punctualLights;

    // True if the output shows what the faces of directional voxels gather.
    constexpr bool gathered() const { return ambientVisibility || indirectLight; }
    // Direct light reaches voxels through the shadow map, so every output that reads voxels needs it.
    constexpr bool shadowMap() const { return hardShadow || softShadow || voxels; }
};

// clang-format off
constexpr std::array<OutputReads, 10> outputTable{{
    //                          name                 hard soft voxels ambient indirect reflections emission punctual
    {Output::phong,             "phong",             0,   0,   0,     0,      0,       0,          1,       1},
    {Output::shadowMap,         "shadow-map",        1,   0,   0,     0,      0,       0,          1,       1},
    {Output::ao,                "ao",                1,   0,   1,     1,      0,       0,          1,       1},
    {Output::gi,                "gi",                1,   0,   1,     0,      1,       1,          1,       1},
    {Output::giConeShadow,      "gi-cone-shadow",    0,   1,   1,     0,      1,       1,          1,       1},
    {Output::ambientVisibility, "ambient_occlusion", 0,   0,   1,     1,      0,       0,          0,       0},
    {Output::indirectLight,     "indirect_light",    0,   0,   1,     0,      1,       0,          0,       0},
    {Output::sunVisibility,     "cone_shadow",       0,   1,   1,     0,      0,       0,          0,       0},
    {Output::irradiance,        "irradiance",        0,   0,   1,     0,      1,       0,          0,       0},
    {Output::specularLight,     "specular_light",    0,   0,   1,     0,      1,       1,          0,       0},
}};
// clang-format on

constexpr const OutputReads& reads(Output output) {
    return outputTable[static_cast<std::size_t>(output) - 1];
}
static_assert(
    [] {
        for (const OutputReads& row : outputTable)
            if (&reads(row.output) != &row) return false;
        return true;
    }(),
    "the table is in the order of the enumeration");

inline const char* outputName(Output output) {
    return reads(output).name;
}

const std::vector<Output>& allModes();
// Parses "all", or names and numbers of modes separated by commas; repeated modes are dropped. Throws
// vct::Error that lists the names if `text` has another one, or none.
std::vector<Output> modesFromText(const std::string& text);

}  // namespace vct
