// A scene on the GPU, and the passes that render frames of it. Read render() in frame.cpp first.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/directional/directional_volume.h"
#include "engine/driver_needs.h"
#include "engine/emitters.h"
#include "engine/gpu_scene.h"
#include "engine/output.h"
#include "engine/packed/packed_volume.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/punctual_lights.h"
#include "engine/passes/shade.h"
#include "engine/passes/shadow_map.h"
#include "engine/settings.h"
#include "engine/step_timer.h"
#include "gl/capabilities.h"
#include "gl/program.h"
#include "image/image.h"

namespace vct {

// Steps that face irradiance takes in a frame. It settles Settings::lightFrames steps after the last change,
// and has converged when it is refined (GatherSettings::refinedDirections).
enum class LightSteps {
    one,  // as an app does
    all,  // those that are left: a still picture
};

struct RenderRequest {
    // At least one, each rendered into a texture of its own: Renderer::output(i) is that of outputs[i]. They
    // should be the same ones in the same order from frame to frame.
    std::vector<Output> outputs;
    Camera camera;
    LightSteps lightSteps = LightSteps::one;
    const GBuffer::Targets* surface = nullptr;  // of the pictures' size; null: the renderer draws it
    bool allBounces = true;                     // in indirect light, or the first bounce alone
};

class Renderer {
  public:
    // Throws vct::Error where the settings are out of range or the driver has not the memory. Passes that no
    // output asks for are never made.
    Renderer(const Scene& scene, const DirectionalLight& light, const Settings& settings,
             const gl::Capabilities& capabilities, gl::ReadShader readShader);

    // Renders one frame. While neither light nor pose changes, shadow map and voxels stay as they are; with
    // Settings::revoxelize they are rebuilt. Throws vct::Error on any GL error; the next frame then rebuilds
    // everything.
    void render(const RenderRequest& request);

    // Gives outputs another size. Shadow map, voxels and light stay. Throws vct::Error where it is
    // out of range.
    void resize(glm::ivec2 size);

    // Shifts outputs by parts of a pixel, to the right and up: their mean over the square of a pixel has
    // smooth edges. Shadow map, voxels and light stay.
    void setPictureShift(const glm::vec2& pixels) { pictureShift_ = pixels; }

    // Takes a pose for frames to come. Cameras and the sun follow it by posed().
    void setPose(const Pose& pose) { nextPose_ = pose; }
    // Turns the sun, in frames to come. Its strength stays, as emission is stored relative to it.
    void setLightDirection(const glm::dvec3& directionToLight) { light_.directionToLight = directionToLight; }
    // Switches one of Scene::punctualLights on or off, in frames to come.
    void setLightOn(std::size_t light, bool on) { punctualLights_.value().setOn(light, on); }
    // Gives the sun another size, in frames to come; full opening angle. Throws vct::Error where it is out of
    // range.
    void setShadowConeAngle(float degrees);

    // An output of the last frame: RGBA16F, relative to radianceScale(), row 0 at the bottom.
    const gl::Texture& output(std::size_t index = 0) const { return shades_.at(index).texture(); }
    float radianceScale() const;
    // The first output of the last frame, linear RGB in the scene's radiance unit, row 0 at the top. Waits
    // for the GPU.
    Image radiance() const;

    // Active voxels per level, empty if no output needed voxels yet. Throws vct::Error where the list
    // overflowed.
    std::vector<std::uint32_t> activeVoxels() const;
    Resources resources() const;

    StepTimer& timer() { return timer_; }
    const Settings& settings() const { return settings_; }
    const Volume& volume() const { return volume_; }
    const gl::ShaderLibrary& shaders() const { return shaders_; }
    // The targets of the last frame, and its shadow map, which every output but `phong` reads.
    GBuffer::Targets surface() { return gBuffer().targets(); }
    const gl::Texture& shadowMapTexture() { return shadowMap().texture(); }

    // Says which voxels are occupied; makes the volume where no output needed it yet.
    const VoxelPyramid& occupancy() { return voxels().occupancy(); }
    // Null until an output needed voxels, and where they are of the other kind.
    const PackedVolume* packed() const { return dynamic_cast<const PackedVolume*>(voxels_.get()); }
    const DirectionalVolume* directional() const {
        return dynamic_cast<const DirectionalVolume*>(voxels_.get());
    }

  private:
    LightFeatures lightFeatures() const;
    void uploadFrameUniforms(const Camera& camera);
    void invalidateCaches();
    void applyPose(const Pose& pose);
    SceneState state() const;  // a copy, to compare later frames with
    // These make the pass when it is asked for the first time.
    GBuffer& gBuffer();
    ShadowMap& shadowMap();
    VoxelVolume& voxels();

    Settings settings_;
    Voxelization voxelization_;
    bool texturesInMainMemory_;
    gl::ShaderLibrary shaders_;
    DirectionalLight light_;
    Bounds boundsWorld_;
    std::size_t triangles_;
    std::optional<gl::Texture> environment_;  // of a sky that is not the same in all directions
    float largestBounceShare_, emissionRange_;
    Volume volume_;
    std::optional<Emitters>
        emitters_;  // where the scene has some, and voxels are of the kind that needs them
    GpuScene scene_;
    std::optional<Pose> nextPose_;
    glm::vec2 pictureShift_{0.0F};
    gl::Buffer frameUniforms_;
    std::optional<GBuffer> gBuffer_;
    std::optional<ShadowMap> shadowMap_;
    std::optional<PunctualLights> punctualLights_;  // the lights besides the sun, where the scene has any
    std::unique_ptr<VoxelVolume> voxels_;
    std::vector<Shade> shades_;  // one for each output of a frame
    StepTimer timer_;
    bool lastFrameFailed_ = false;
};

}  // namespace vct
