// The G-buffer pass: albedo, normal and depth of the visible surfaces (thesis 4.3, "render data").
#pragma once

#include <optional>

#include "engine/gpu_scene.h"
#include "engine/programs.h"
#include "engine/resource.h"
#include "gl/objects.h"

namespace vct {

// Parts of the G-buffer that exist only if the scene's materials need them.
struct ExtraTargets {
    bool emissive = false;       // a material emits light or is unlit
    bool gloss = false;          // a material is glossy
    bool mappedNormals = false;  // a material has a normal map
    bool isPlain = false;        // emission does not vary over a material, so few bits show no steps
};
// The extra targets that a scene needs.
ExtraTargets extraTargets(const SceneFeatures& features, Voxels voxels);
gl::ProgramDescription gBufferProgram(unsigned features, ExtraTargets targets);

class GBuffer {
  public:
    GBuffer(const gl::ShaderLibrary& shaders, const GpuScene& scene, glm::ivec2 size, ExtraTargets targets);

    struct Targets {
        const gl::Texture* albedo;    // RGBA8: square root of linear albedo; alpha: bits of encodeNormals()
        const gl::Texture* normal;    // RG16UI: encodeNormals(), world space, towards the viewer
        const gl::Texture* emissive;  // RGBA16F, relative to E/pi; null without ExtraTargets::emissive
        const gl::Texture* gloss;     // RG8: metallic, roughness; null without ExtraTargets::gloss
        const gl::Texture* depth;     // 1 if there is no surface
        // True: `normal` is RGBA16UI with the normal map's normal, by encodeOctahedral(), in blue and alpha.
        bool mappedNormals;
    };
    Targets draw(const GpuScene& scene, const glm::mat4& clipFromVolume);
    // Recreates the targets in another size, in pixels. The programs are kept.
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
