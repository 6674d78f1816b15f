// One frame through directional coverage voxels with its passes laid open: over a volume of the test's
// choosing, and with what each face received.
#pragma once

#include <vector>

#include "engine/directional/directional_mipmapper.h"
#include "engine/directional/directional_voxelizer.h"
#include "engine/directional/irradiance.h"
#include "engine/frame_uniforms.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/shade.h"
#include "engine/passes/shadow_map.h"
#include "image/image.h"
#include "platform/context.h"
#include "support/cpu_directional_cones.h"
#include "support/faces.h"
#include "support/received.h"
#include "support/surface_pixels.h"

namespace vct::test {

class GatheredFrame {
  public:
    // Draws the shadow map and the G-buffer and makes the voxels, with direct and emitted light only.
    GatheredFrame(const Context& context, const Scene& scene, const DirectionalLight& light,
                  const Settings& settings, const Volume& volume, const Camera& camera);

    const shared::FrameUniforms& uniforms() const { return uniforms_; }

    std::vector<FaceLevel> levels() const { return readFaces(voxels_); }
    std::vector<SurfacePixel> pixels() const;

    // So many steps of the received light. `allBounces`: or the first one alone.
    void step(int steps, bool allBounces);
    void settle(bool allBounces);
    // Where none was made, of one bounce.
    ReceivedFaces received();
    std::map<std::uint32_t, FacePlane> planes() const { return readPlanes(voxels_); }
    const gl::Texture& irradiance() const { return *light_.irradiance(); }
    const gl::Texture& bricks() const { return *light_.bricks(); }

    // `view`: VCT_VIEW_*, or a mode. Where no step was made, when the light stands still: that of one bounce
    // in VCT_VIEW_INDIRECT, as the light parts show it.
    Image view(int view);

  private:
    gl::ShaderLibrary shaders_;
    shared::FrameUniforms uniforms_;
    GpuScene scene_;
    gl::Buffer uniformBuffer_;
    ShadowMap shadowMap_;
    GBuffer gBuffer_;
    DirectionalVoxels voxels_;
    DirectionalMipmapper mipmapper_;
    Irradiance light_, occlusion_;
    Shade shade_;
};

}  // namespace vct::test
