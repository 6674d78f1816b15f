// The scene from the camera (thesis 4.3, "render data").
#pragma once

#include <optional>

#include "engine/gpu_scene.h"
#include "engine/programs.h"
#include "engine/resource.h"
#include "gl/objects.h"

namespace vct {

// What the G-buffer has only where a material of the scene emits or is unlit, is glossy, or has a normal map.
struct ExtraTargets {
    bool emissive = false;
    bool gloss = false;
    bool mappedNormals = false;
};
// Those that a scene needs.
ExtraTargets extraTargets(const SceneFeatures& features, Specular specular);
gl::ProgramDescription gBufferProgram(unsigned features, ExtraTargets targets);

class GBuffer {
  public:
    GBuffer(const gl::ShaderLibrary& shaders, const GpuScene& scene, glm::ivec2 size, ExtraTargets targets);

    struct Targets {
        const gl::Texture* albedo;    // RGBA8: square root of linear albedo
        const gl::Texture* normal;    // RG16UI: octahedral, world space, towards the viewer
        const gl::Texture* emissive;  // RGBA16F relative to E/pi; null where nothing emits
        const gl::Texture* gloss;     // RG8: metallic, roughness; null where nothing is glossy
        const gl::Texture* depth;     // 1 where there is no surface
        bool mappedNormals;  // `normal` is RGBA16UI: as normal maps turn it, and, in blue and alpha, of the
                             // geometry
    };
    Targets draw(const GpuScene& scene);
    // Makes the targets anew; the programs stay.
    void resize(glm::ivec2 size);

    Targets targets() const;
    Resources resources() const;

  private:
    MaterialPrograms programs_;
    ExtraTargets extra_;
    gl::Texture albedo_, normal_, depth_;
    std::optional<gl::Texture> emissive_, gloss_;
    gl::Framebuffer framebuffer_;
};

}  // namespace vct
