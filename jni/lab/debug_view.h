// Renders intermediate results of a frame as pictures to look at.
#pragma once

#include <string>
#include <vector>

#include "engine/renderer.h"
#include "image/image.h"

namespace vct {

// The program for a view, one of VCT_DEBUG_VIEW_*.
gl::ProgramDescription debugViewProgram(int view);

struct DebugView {
    std::string name;      // file name without extension, such as "g_buffer_albedo"
    Image image;           // linear RGB
    bool hasUnits;         // false: the values are only for looking at, not data
    bool isShare = false;  // the values are shares of 1 and not light, so no exposure applies
};

// Renders the parts of the light from `camera`, each alone and converged: ambient_occlusion, indirect_light
// (one bounce), cone_shadow, and specular_light if the scene has glossy materials.
std::vector<DebugView> lightParts(Renderer& renderer, const Camera& camera);
// The names of all that lightParts() may return.
std::vector<std::string> lightPartNames();
// Renders all intermediate results, including the parts of the light.
std::vector<DebugView> debugViews(Renderer& renderer, const Camera& camera);

}  // namespace vct
