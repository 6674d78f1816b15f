// What the G-buffer says of each pixel, on the CPU.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "engine/passes/g_buffer.h"
#include "gl/program.h"
#include "shared/layout.h"

namespace vct::test {

struct SurfacePixel {
    bool surface = false;  // false: sky, and nothing else is set
    glm::dvec3 positionVolume{0.0};
    glm::dvec3 normal{0.0};
    glm::dvec3 albedo{0.0};
};

// Row by row from the top, as in an Image. Of `frame`: volumeFromWindow.
std::vector<SurfacePixel> surfacePixels(const gl::ShaderLibrary& shaders, const GBuffer::Targets& targets,
                                        const shared::FrameUniforms& frame);

}  // namespace vct::test
