// The renderer: a scene on the GPU and the passes that render frames of it. Start with render() in frame.cpp.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/baked_light.h"
#include "engine/cascades.h"
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

// The number of steps that face irradiance takes in a frame. It takes Settings::lightFrames steps after a
// change, and then those of the refinement (GatherSettings::refinedDirections), until it has converged.
enum class LightSteps {
    none,  // for another view of the same frame; one as long as there is no light
    one,   // for an app, which shows every frame
    all,   // for a still picture: every step until face irradiance has converged
};

struct LightProgress {
    int done = 0, total = 0;
};

struct RenderRequest {
    // At least one. Each has a texture of its own: Renderer::output(i) holds outputs[i]. Keep their order
    // from frame to frame, because programs and textures are kept by index.
    std::vector<Output> outputs;
    Camera camera;
    LightSteps lightSteps = LightSteps::one;
    const GBuffer::Targets* surface = nullptr;  // G-buffer of Settings::size; null: the renderer draws it
    bool allBounces = true;                     // false: indirect light has the first bounce only
    OnLightStep onLightStep = {};
};

// The inputs of shaders/directional/look_up.glsl. Those that the scene does not need are null.
struct LookUpInputs {
    // Static and dynamic index, its pages, blocks, bricks, their places, walls, sky.
    std::array<const gl::Texture*, 8> textures{};
    std::array<const gl::Buffer*, 2> uniforms{};  // frame, emitters
    const gl::Buffer* faces = nullptr;            // a storage buffer
};

class Renderer {
  public:
    // Throws vct::Error if a setting is out of range, or if the driver lacks a feature or memory. Passes are
    // created when an output first needs them. `programs`: null if the renderer shares its programs with no
    // other.
    Renderer(const Scene& scene, const DirectionalLight& light, const Settings& settings,
             const gl::Capabilities& capabilities, gl::ReadShader readShader,
             std::shared_ptr<gl::ProgramCache> programs = {});

    // Renders one frame. Shadow maps and voxels are rebuilt only if a light or the pose has changed, or if
    // Settings::revoxelize asks for it. Throws vct::Error on any GL error; the next frame then rebuilds
    // everything.
    void render(const RenderRequest& request);

    // Voxelizes the static geometry around the camera now. Otherwise the first frame that reads voxels does
    // it, and takes longer.
    void prepareVoxels(const Camera& camera);

    // Changes the size of the outputs, in pixels. Shadow maps, voxels and their light are kept. Throws
    // vct::Error if the size is out of range.
    void resize(glm::ivec2 size);

    // Frees what frames of this output do not read: voxels, their light, shadow maps. Another output makes
    // them again.
    void dropUnread(Output output);

    // Shifts the picture by fractions of a pixel, to the right and up. The mean of frames with shifts within
    // one pixel is anti-aliased. Shadow maps, voxels and their light are kept.
    void setPictureShift(const glm::vec2& pixels) { pictureShift_ = pixels; }

    // Sets the pose of the next frames. The caller moves the camera and the sun accordingly (posed()).
    void setPose(const Pose& pose);
    // Replaces the vertices of a deforming object in the next frames (GpuScene::setVertices()).
    void setVertices(int node, const ExternalVertices& vertices) { scene_.setVertices(node, vertices); }
    // Shows or hides the object of an animation node in the next frames, and scales its emission, by 0 to 1.
    void setAppearance(int node, bool isVisible, float emissionScale);
    // Changes of the scene's contents for the next frames, as in GpuScene. A node of an added instance must
    // be in the next pose. If a material of a static instance changes, voxels and light are made again.
    void setTexture(std::size_t texture, GLuint external) { scene_.setTexture(texture, external); }
    void addMesh(std::size_t index, const Mesh& mesh) { scene_.addMesh(index, mesh); }
    void removeMesh(std::size_t index) { scene_.removeMesh(index); }
    void addInstance(std::size_t index, const Instance& instance, const Material& material,
                     unsigned features) {
        scene_.addInstance(index, instance, material, features);
    }
    void removeInstance(std::size_t index) { scene_.removeInstance(index); }
    void setMaterial(std::size_t instance, const Material& material, unsigned features);
    // The features that materials may have, and the largest radiance that they may emit.
    const SceneFeatures& features() const { return scene_.features(); }
    float maxEmission() const { return emissionRange_ * radianceUnit_; }
    // Sets the unit vector towards the sun (world space) for the next frames.
    void setLightDirection(const glm::dvec3& directionToLight);
    // Sets colour and illuminance of the sun for the next frames. radianceScale() stays.
    void setSunlight(const glm::vec3& color, float illuminance);
    // Sets the radiance of a sky of one colour for the next frames. The scene must have no picture of a sky.
    void setSky(const glm::vec3& radiance);
    // Replaces the picture of the sky for the next frames. The scene must have one already.
    void setSky(std::shared_ptr<const Environment> environment);
    // Switches one of Scene::punctualLights on or off for the next frames.
    void setLightOn(std::size_t light, bool on);
    // Replaces a punctual light for the next frames, or removes it. `index`: below the number of the scene's
    // punctual lights and those that there is room for.
    void setPunctualLight(std::size_t index, const std::optional<PunctualLight>& light);
    // Sets the full opening angle of the sun's disc for the next frames. Throws vct::Error if it is out of
    // range.
    void setShadowConeAngle(float degrees);

    // Baked light of the scene as the constructor got it (lightKey()). bakeLight() needs a frame with
    // LightSteps::all, and no change of lights, sky and materials. useBakedLight() comes before the first
    // frame with indirect light. Both throw vct::Error where requireBakeable() does.
    void requireBakeable() const;  // throws if the settings have no light to bake
    std::vector<BakedLight::Face> bakeLight() const;
    void useBakedLight(BakedLight light);

    // An output of the last frame: RGBA16F, Settings::size, row 0 at the bottom. Multiply its values by
    // radianceScale() to get the scene's radiance unit.
    const gl::Texture& output(std::size_t index = 0) const { return shades_.at(index).texture(); }
    float radianceScale() const;
    // The first output of the last frame, linear RGB in the scene's radiance unit, row 0 at the top. Waits
    // for the GPU.
    Image radiance() const;

    // The program defines of shaders/directional/look_up.glsl, without its bindings.
    std::vector<std::string> lookUpDefines() const;
    // The inputs as the last frame left them. Throws vct::Error if no frame has gathered light with
    // directional voxels.
    LookUpInputs lookUpInputs() const;

    // Number of active voxels per level; empty if no output has needed voxels yet. Waits for the GPU. Throws
    // vct::Error if the list overflowed.
    std::vector<std::uint32_t> activeVoxels() const;
    Resources resources() const;

    StepTimer& timer() { return timer_; }
    const Settings& settings() const { return settings_; }
    const Volume& volume() const { return volume_; }
    const gl::ShaderLibrary& shaders() const { return shaders_; }
    // The renderer's own G-buffer and the sun's shadow map, as the last frame left them.
    GBuffer::Targets surface() { return gBuffer().targets(); }
    const gl::Texture& shadowMapTexture() { return shadowMap().texture(); }

    // The occupied voxels. Creates the volume if no output has needed it yet.
    const VoxelPyramid& occupancy() { return voxels().occupancy(); }
    // Null if no output has needed voxels yet, or if the voxels are of the other kind.
    const PackedVolume* packed() const { return dynamic_cast<const PackedVolume*>(voxels_.get()); }
    const DirectionalVolume* directional() const {
        return dynamic_cast<const DirectionalVolume*>(voxels_.get());
    }
    // The light steps since the last change, and all that follow a change. Both are 0 if no face gathers
    // light.
    LightProgress lightProgress() const;

  private:
    LightFeatures lightFeatures() const;
    shared::FrameUniforms uploadFrameUniforms(const Camera& camera, const Cascades& last);
    void invalidateCaches();
    void applyPose(const Pose& pose);
    SceneState state() const;  // a copy, which later frames are compared with
    bool hasLight() const;     // a frame has gathered light, or the voxels do not gather any
    // Each returns its pass, and creates it in the first call.
    GBuffer& gBuffer();
    ShadowMap& shadowMap();
    VoxelVolume& voxels();

    Settings settings_;
    Voxelization voxelization_;
    int pixelSamples_;
    bool texturesInMainMemory_;
    gl::ShaderLibrary shaders_;
    DirectionalLight light_;
    Bounds boundsWorld_;
    std::size_t triangles_;
    std::optional<gl::Texture> environment_;  // Settings::environment as a cube map
    float radianceUnit_, emissionRange_;
    Volume volume_;
    Cascades cascades_, voxelizedCascades_;  // their places in this frame, and in the last one with voxels
    bool softLights_;                        // a punctual light has a size of its own
    std::optional<Emitters> emitters_;       // compact emitters; directional voxels only
    bool hasEmission_;                       // LightFeatures::emission
    GpuScene scene_;
    std::optional<Pose> nextPose_;
    glm::vec2 pictureShift_{0.0F};
    gl::Buffer frameUniforms_;
    std::optional<GBuffer> gBuffer_;
    std::optional<ShadowMap> shadowMap_;
    std::optional<PunctualLights> punctualLights_;  // absent if the scene has none
    std::unique_ptr<VoxelVolume> voxels_;
    std::vector<Shade> shades_;                        // one per output of a frame
    std::uint64_t skyChanges_ = 0, lightChanges_ = 0;  // see SceneState
    std::shared_ptr<const BakedLight> bakedLight_;     // null: none
    bool isLightChanged_ = false;                      // since the constructor
    StepTimer timer_;
    bool lastFrameFailed_ = false;
};

}  // namespace vct
