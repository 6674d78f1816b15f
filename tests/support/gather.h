// The cone tracer alone: a scene's G-buffer over voxels that a test has written.
#pragma once

#include <functional>
#include <vector>

#include "engine/frame_uniforms.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/shade.h"
#include "engine/renderer.h"
#include "platform/context.h"
#include "support/voxels.h"

namespace vct::test {

// What one view of the tracer shows per pixel, and where.
struct GatherResult {
    Image image;
    std::vector<glm::dvec3> positions;  // volume space; those on the sky are left out of both
    std::vector<float> values;          // red
};

// Renders `scene` once with its own voxels, lets `editBase` change the base level (the other levels follow on
// the CPU), and draws `view` (VCT_VIEW_*) from `camera`.
GatherResult gatherOver(const Context& context, const Scene& scene, const DirectionalLight& light,
                        const Settings& settings, const Camera& camera, int view,
                        const std::function<void(Words& base)>& editBase);

}  // namespace vct::test
