// The outputs that a frame can produce, and what each of them reads.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "shared/layout.h"

namespace vct {

enum class Output {
    // The five modes, which are the thesis's scenes (5.1.2).
    phong = VCT_MODE_PHONG,                  // Phong, diffuse and specular, no shadow
    shadowMap = VCT_MODE_SHADOW_MAP,         // and the shadow map
    ao = VCT_MODE_AO,                        // and cone-traced ambient occlusion
    gi = VCT_MODE_GI,                        // and a diffuse bounce
    giConeShadow = VCT_MODE_GI_CONE_SHADOW,  // the shadow cone in place of the shadow map
    // Parts of the light, each alone.
    ambientVisibility = VCT_VIEW_AO,
    indirectLight = VCT_VIEW_INDIRECT,
    sunVisibility = VCT_VIEW_CONE_SHADOW,
    irradiance = VCT_VIEW_IRRADIANCE,  // of the indirect light, relative to the sun's
    specularLight = VCT_VIEW_SPECULAR,
};

struct OutputReads {
    Output output;
    const char* name;  // also of its files
    bool hardShadow;   // the shadow map, compared
    bool softShadow;   // the visible share of the sun's disc
    bool voxels;
    bool ambientVisibility;
    bool indirectLight;
    bool reflections;  // and the G-buffer's gloss
    bool emission;     // of the G-buffer
    bool punctualLights;

    // Voxels are lit through it.
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
// "all", or names and numbers of modes separated by commas, each mode once; throws vct::Error listing the
// names.
std::vector<Output> modesFromText(const std::string& text);

}  // namespace vct
