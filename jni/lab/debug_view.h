// The intermediates of a frame as pictures for people.
#pragma once

#include <string>
#include <vector>

#include "engine/renderer.h"
#include "image/image.h"

namespace vct {

// `view`: one of VCT_DEBUG_VIEW_*.
gl::ProgramDescription debugViewProgram(int view);

struct DebugView {
    std::string name;      // "g_buffer_albedo": a file name without its ending
    Image image;           // linear RGB, scaled for the eye
    bool hasUnits;         // false: made for the eye only, no use as data
    bool isShare = false;  // of 1: no light, which an exposure would be of
};

// The parts of the light, each alone and converged, from `camera`: ambient_occlusion,
// indirect_light (of one bounce), cone_shadow, and specular_light where something is glossy.
std::vector<DebugView> lightParts(Renderer& renderer, const Camera& camera);
// Every intermediate, the light parts among them.
std::vector<DebugView> debugViews(Renderer& renderer, const Camera& camera);

}  // namespace vct
