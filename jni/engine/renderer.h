// A scene on the GPU, and what draws frames of it. Read draw() in frame.cpp first.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/directional/directional_volume.h"
#include "engine/driver_needs.h"
#include "engine/emitters.h"
#include "engine/gpu_scene.h"
#include "engine/packed/packed_volume.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/punctual_lights.h"
#include "engine/passes/shade.h"
#include "engine/passes/shadow_map.h"
#include "engine/picture.h"
#include "engine/settings.h"
#include "gl/capabilities.h"
#include "gl/program.h"
#include "image/image.h"
#include "lab/step_timer.h"

namespace vct {

class Renderer {
  public:
    // Throws vct::Error where the settings are out of range or the driver has not the memory. Passes that no
    // mode asks for are never made.
    Renderer(const Scene& scene, const DirectionalLight& light, const Settings& settings,
             const gl::Capabilities& capabilities, gl::ReadShader readShader);

    // Draws one frame. While neither light nor pose changes, shadow map and voxels stay as they are. What the
    // surfaces receive comes one step nearer to its final value, and stands still Settings::lightFrames
    // frames after the last change. With Settings::revoxelize everything is made. Throws vct::Error on any GL
    // error; the next frame then makes everything anew.
    void frame(Mode mode, const Camera& camera);
    // Draws one frame in which all those steps are done: a still picture.
    void renderConverged(Mode mode, const Camera& camera);
    // Draws a part of the light alone, converged: one of VCT_VIEW_*. `allBounces`: or the first one alone.
    void renderPart(Picture view, const Camera& camera, bool allBounces);

    // Draws several pictures of one moment, each into a texture of its own: output(i) is that of pictures[i].
    // They should be the same ones in the same order from frame to frame. `surface`: what the camera sees, in
    // textures of the picture's size; null: the renderer draws it. `converged`: see above.
    void frame(const std::vector<Picture>& pictures, const Camera& camera, const GBuffer::Targets* surface,
               bool converged);

    // Gives pictures to come another size. Shadow map, voxels and light stay. Throws vct::Error where it is
    // out of range.
    void resize(glm::ivec2 size);

    // Shifts pictures to come by parts of a pixel, to the right and up: their mean over the square of a pixel
    // has smooth edges. Shadow map, voxels and light stay.
    void setPictureShift(const glm::vec2& pixels) { pictureShift_ = pixels; }

    // Moves what moves, in frames to come. What the pose does to cameras and lights, posed() says.
    void setPose(const Pose& pose) { nextPose_ = pose; }
    // Turns the light, in frames to come. Its strength stays, as emission is stored relative to it.
    void setLightDirection(const glm::dvec3& towardsLight) { light_.towardsLight = towardsLight; }
    // Switches one of Scene::punctualLights on or off, in frames to come.
    void setLightOn(std::size_t light, bool on) { punctualLights_.value().setOn(light, on); }
    // Gives the sun another size, in frames to come; full opening angle. Throws vct::Error where it is out of
    // range.
    void setShadowConeAngle(float degrees);

    // The last frame: RGBA16F, relative to radianceScale(), row 0 at the bottom.
    const gl::Texture& output(std::size_t picture = 0) const { return shades_.at(picture).texture(); }
    float radianceScale() const;
    // The last frame, linear RGB in the scene's radiance unit, row 0 at the top. Waits for the GPU.
    Image radiance() const;

    // Active voxels per level, empty if no mode needed voxels yet. Throws vct::Error where the list
    // overflowed.
    std::vector<std::uint32_t> activeVoxels() const;
    Resources resources() const;

    StepTimer& timer() { return timer_; }
    const Settings& settings() const { return settings_; }
    const Volume& volume() const { return volume_; }
    const gl::ShaderLibrary& shaders() const { return shaders_; }
    // The targets of the last frame, and its shadow map, which is drawn by every mode but the first.
    GBuffer::Targets surface() { return gBuffer().targets(); }
    const gl::Texture& shadowMapTexture() { return shadowMap().texture(); }

    // Which voxels are occupied; makes the volume where no mode needed it yet.
    const VoxelPyramid& occupancy() { return voxels().occupancy(); }
    // Null until a mode needed voxels, and where they are of the other kind.
    const PackedVolume* packed() const { return dynamic_cast<const PackedVolume*>(voxels_.get()); }
    const DirectionalVolume* directional() const {
        return dynamic_cast<const DirectionalVolume*>(voxels_.get());
    }

  private:
    // Of the received light, towards its final value. `allBounces`: or the first one alone.
    struct LightSteps {
        int atMost;
        bool allBounces;
    };
    void draw(const std::vector<Picture>& pictures, const Camera& camera, LightSteps steps,
              const GBuffer::Targets* callersSurface = nullptr);
    LightSources sources() const;
    void uploadFrameUniforms(const Camera& camera);
    void forgetWhatWasMade();
    void setPoseNow(const Pose& pose);
    SceneState state() const;  // of the moment: a copy, to compare later frames with
    // These make the pass when it is asked for the first time.
    GBuffer& gBuffer();
    ShadowMap& shadowMap();
    VoxelVolume& voxels();

    Settings settings_;
    bool texturesInMainMemory_;
    gl::ShaderLibrary shaders_;
    DirectionalLight light_;
    Bounds boundsWorld_;
    std::size_t triangles_;
    std::optional<gl::Texture> environment_;  // the sky, where it is not the same in all directions
    float faceRadianceRange_, largestBounceShare_;
    Volume volume_;
    std::optional<Emitters>
        emitters_;  // where the scene has lamps, and voxels are of the kind that need them
    GpuScene scene_;
    std::optional<Pose> nextPose_;
    glm::vec2 pictureShift_{0.0F};
    gl::Buffer frameUniforms_;
    std::optional<GBuffer> gBuffer_;
    std::optional<ShadowMap> shadowMap_;
    std::optional<PunctualLights> punctualLights_;  // the lights besides the sun, where the scene has any
    std::unique_ptr<VoxelVolume> voxels_;
    std::vector<Shade> shades_;  // of the pictures of one frame
    StepTimer timer_;
    bool unfinished_ = false;  // the last frame threw
};

}  // namespace vct
