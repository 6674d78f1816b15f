// One frame through directional coverage voxels with its passes laid open: over a volume and faces of the
// test's choosing.
#pragma once

#include <vector>

#include "image/image.h"
#include "platform/context.h"
#include "render/cone_tracer.h"
#include "render/face_mipmapper.h"
#include "render/face_voxelizer.h"
#include "render/frame_uniforms.h"
#include "render/g_buffer.h"
#include "render/gather.h"
#include "render/shadow_map.h"
#include "support/faces.h"
#include "support/surface_pixels.h"

namespace vct::test {

class GatheredFrame {
  public:
    // Draws the shadow map and the G-buffer and makes the voxels, with direct and emitted light only.
    GatheredFrame(const Context& context, const Scene& scene, const DirectionalLight& light,
                  const Settings& settings, const Volume& volume, const Camera& camera);

    const shared::FrameUniforms& uniforms() const { return uniforms_; }

    std::vector<FaceLevel> levels() const { return readFaces(voxels_); }
    // The other levels follow on the CPU.
    void replaceFaces(const FaceLevel& base) { writeFacePyramid(voxels_, base); }

    std::vector<SurfacePixel> pixels() const;

    // `view`: VCT_VIEW_*, or a mode.
    Image view(int view);

  private:
    gl::ShaderLibrary shaders_;
    shared::FrameUniforms uniforms_;
    GpuScene scene_;
    gl::Buffer uniformBuffer_;
    ShadowMap shadowMap_;
    GBuffer gBuffer_;
    FaceVoxels voxels_;
    Gather light_, occlusion_;
    ConeTracer coneTracer_;
};

}  // namespace vct::test
