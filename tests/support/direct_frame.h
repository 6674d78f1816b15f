// The sun's light alone on what a camera sees, and on the faces of the voxels.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/frame_uniforms.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/shade.h"
#include "engine/passes/shadow_map.h"
#include "image/image.h"
#include "platform/context.h"
#include "support/renderers.h"
#include "support/surface_pixels.h"

namespace vct::test {

class DirectFrame {
  public:
    DirectFrame(const Context& context, Scene scene, const Settings& settings, const Camera& camera,
                const gl::ReadShader& readShader = testShaders());

    // Draws the shadow map.
    void setLight(const glm::dvec3& towardsLight);

    // Share of the sun that each pixel sees, by the compared map (modes 3 and 4) or by the soft shadow
    // (mode 5); row by row from the top. 0 where the surface faces away.
    std::vector<float> hardShadow();
    std::vector<float> softShadow();

    // In world space, instead of the volume's.
    const std::vector<SurfacePixel>& pixels() const { return pixels_; }
    const glm::dmat4& shadowFromVolume() const { return shadowFromVolume_; }

  private:
    void upload();
    Image view(int view);

    gl::ShaderLibrary shaders_;
    Scene plain_;
    Settings settings_;
    Camera camera_;
    Volume volume_;
    GpuScene scene_;
    gl::Buffer uniformBuffer_;
    ShadowMap shadowMap_;
    GBuffer gBuffer_;
    Shade shade_;
    DirectionalLight light_;
    glm::dmat4 shadowFromVolume_{1.0};
    std::vector<SurfacePixel> pixels_;
};

}  // namespace vct::test
