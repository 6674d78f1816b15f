// One frame with its passes laid open: over a volume and voxels of the test's choosing, and with everything
// that the cone tracer reads brought to the CPU.
#pragma once

#include <vector>

#include "engine/frame_uniforms.h"
#include "engine/packed/packed_mipmapper.h"
#include "engine/packed/packed_voxelizer.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/shade.h"
#include "engine/passes/shadow_map.h"
#include "image/image.h"
#include "platform/context.h"
#include "support/surface_pixels.h"
#include "support/voxels.h"

namespace vct::test {

class TracedFrame {
  public:
    // Draws the shadow map and the G-buffer and makes the voxels.
    TracedFrame(const Context& context, const Scene& scene, const DirectionalLight& light,
                const Settings& settings, const Volume& volume, const Camera& camera);

    const shared::FrameUniforms& uniforms() const { return uniforms_; }

    Words level(int level) const;
    std::vector<Words> levels() const;
    // The other levels follow on the CPU.
    void replaceVoxels(const Words& base) { writePyramid(pyramid_.texture(), base); }

    std::vector<SurfacePixel> pixels() const;

    // `view`: VCT_VIEW_*.
    Image view(int view);

  private:
    gl::ShaderLibrary shaders_;
    shared::FrameUniforms uniforms_;
    GpuScene scene_;
    gl::Buffer uniformBuffer_;
    ShadowMap shadowMap_;
    GBuffer gBuffer_;
    VoxelPyramid pyramid_;
    Shade shade_;
};

}  // namespace vct::test
