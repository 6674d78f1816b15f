// Sets up the renderer, creates its passes when they are first needed, and fills the frame uniforms.
// frame.cpp has the frame itself.
#include "engine/renderer.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "core/error.h"
#include "core/memory.h"
#include "engine/environment.h"
#include "engine/frame_uniforms.h"
#include "engine/programs.h"
#include "engine/radiance_unit.h"
#include "gl/debug.h"
#include "gl/read_back.h"

namespace vct {

namespace {

const Settings& validated(const Settings& settings, const gl::Capabilities& capabilities) {
    validate(settings);
    requireNeeds(settings, capabilities);
    return settings;
}

LightSize lightSize(const Settings& settings) {
    return {settings.lightRadius, settings.shadowConeAngleDeg};
}

bool hasSize(const PunctualLight& light) {
    return light.size.value_or(0.0) > 0.0;
}

// The largest radiance that a surface emits, in the scene's unit; 1 if none emits.
float largestEmission(const Scene& scene) {
    float largest = 0.0F;
    for (const Material& material : scene.materials)
        largest = std::max({largest, material.emissive.r, material.emissive.g, material.emissive.b});
    return largest > 0.0F ? largest : 1.0F;
}

// Rays of a look-up in the air (docs/embedding.md has the measurement); a power of two.
constexpr int lookUpDirections = 8;

// The volume with voxels of the finest cascade's size.
Volume finestVoxels(Volume volume, int cascades) {
    volume.grid <<= cascades - 1;
    return volume;
}

// The scene's compact emitters; none for packed voxels, which have no cones for them.
std::optional<Emitters> compactEmitters(const Scene& scene, const Volume& volume, const Settings& settings,
                                        float radianceUnit) {
    if (settings.voxels != Voxels::directional) return {};
    const std::vector<EmitterPart> parts = emitterParts(scene, volume);
    if (parts.empty()) return {};
    return Emitters(scene, parts, volume, radianceUnit);
}

// True if surfaces emit light, or may later, that are no compact emitters.
bool hasOtherEmitters(const Scene& scene, const std::optional<Emitters>& emitters) {
    const SceneFeatures features = featuresOf(scene);
    if (features.materialsChange) return features.has(featureEmissive);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Material& material = scene.materials[scene.meshes[scene.instances[i].mesh].material];
        const bool isCompact = emitters && emitters->instances().at(i);
        if (material.emissive != glm::vec3(0.0F) && !isCompact) return true;
    }
    return false;
}

}  // namespace

Renderer::Renderer(const Scene& scene, const DirectionalLight& light, const Settings& settings,
                   const gl::Capabilities& capabilities, gl::ReadShader readShader,
                   std::shared_ptr<gl::ProgramCache> programs)
    : settings_(validated(settings, capabilities)),
      voxelization_(voxelizationFor(settings.voxels, capabilities)),
      pixelSamples_(pixelSamplesFor(capabilities)),
      texturesInMainMemory_(capabilities.texturesInMainMemory),
      shaders_(shaderLibrary(settings, capabilities, std::move(readShader), std::move(programs))),
      light_(light),
      boundsWorld_(scene.boundsWorld),
      triangles_(scene.triangleCount()),
      radianceUnit_(radianceUnit(scene, light, settings)),
      emissionRange_(largestEmission(scene) / radianceUnit_),
      volume_(volumeAround(scene.boundsWorld, settings.grid)),
      cascades_(settings.cascades, settings.grid),
      voxelizedCascades_(cascades_),
      softLights_(std::any_of(scene.punctualLights.begin(), scene.punctualLights.end(), hasSize)),
      emitters_(compactEmitters(scene, finestVoxels(volume_, settings.cascades), settings, radianceUnit_)),
      hasEmission_(hasOtherEmitters(scene, emitters_)),
      scene_(shaders_, scene, emitters_ ? emitters_->instances() : std::vector<bool>(), volume_,
             radianceUnit_, capabilities.uniformBufferOffsetAlignment, voxelization_),
      frameUniforms_("frame uniforms", GL_UNIFORM_BUFFER, sizeof(shared::FrameUniforms), nullptr,
                     GL_DYNAMIC_DRAW),
      // A software driver has no GPU clock, and each query makes it draw an empty picture: 0.1 ms or more.
      timer_(capabilities.softwareDriver ? 0 : capabilities.gpuTimerBits) {
    if (settings.environment) environment_ = settings.environment->texture(radianceUnit_);
    if (scene.mayHavePunctualLights())
        punctualLights_.emplace(shaders_, scene_, scene, volume_, glm::pi<double>() * radianceUnit_,
                                lightSize(settings));
    shades_.emplace_back(shaders_, lightFeatures(), settings_);
    gl::checkErrors("setting up the renderer");
}

void Renderer::resize(glm::ivec2 size) {
    Settings changed = settings_;
    changed.size = size;
    validate(changed);
    settings_ = changed;
    if (gBuffer_) gBuffer_->resize(size);
    for (Shade& shade : shades_)
        shade.resize(size);
}

void Renderer::dropUnread(Output output) {
    if (!reads(output).shadowMap()) shadowMap_.reset();
    if (!reads(output).voxels)
        voxels_.reset();
    else if (voxels_)
        voxels_->dropUnread(output);
}

void Renderer::setShadowConeAngle(float degrees) {
    Settings changed = settings_;
    changed.shadowConeAngleDeg = degrees;
    validate(changed);
    settings_ = changed;
    if (punctualLights_ && settings_.lightRadius > 0.0F) punctualLights_->setSize(lightSize(settings_));
}

void Renderer::setPunctualLight(std::size_t index, const std::optional<PunctualLight>& light) {
    punctualLights_.value().setLight(index, light);
    if (light && hasSize(*light)) {
        softLights_ = true;
        for (Shade& shade : shades_)
            shade.useSoftLights();
    }
    ++lightChanges_;
    isLightChanged_ = true;
}

void Renderer::setAppearance(int node, bool isVisible, float emissionScale) {
    scene_.setAppearance(node, isVisible, emissionScale);
    if (emitters_) emitters_->setScale(node, isVisible ? emissionScale : 0.0F);
    ++lightChanges_;
    isLightChanged_ = true;
}

void Renderer::setMaterial(std::size_t instance, const Material& material, unsigned features) {
    const bool isDynamic = scene_.setMaterial(instance, material, features);
    if (emitters_) emitters_->setRadiance(instance, material.emissive);
    ++lightChanges_;
    isLightChanged_ = true;
    if (isDynamic) return;
    // Its holes may be others.
    invalidateCaches();
    voxels_.reset();
}

void Renderer::setPose(const Pose& pose) {
    nextPose_ = pose;
    isLightChanged_ |= scene_.features().movingLight;
}

void Renderer::setLightDirection(const glm::dvec3& directionToLight) {
    isLightChanged_ |= light_.directionToLight != directionToLight;
    light_.directionToLight = directionToLight;
}

void Renderer::setLightOn(std::size_t light, bool on) {
    punctualLights_.value().setOn(light, on);
    isLightChanged_ |= !on;
}

void Renderer::setSunlight(const glm::vec3& color, float illuminance) {
    light_.color = color;
    light_.intensity = illuminance;
    ++lightChanges_;
    isLightChanged_ = true;
}

void Renderer::setSky(const glm::vec3& radiance) {
    settings_.skyRadiance = radiance;
    ++skyChanges_;
    isLightChanged_ = true;
}

void Renderer::setSky(std::shared_ptr<const Environment> environment) {
    environment_ = environment->texture(radianceUnit_);
    settings_.environment = std::move(environment);
    ++skyChanges_;
    isLightChanged_ = true;
}

void Renderer::requireBakeable() const {
    if (settings_.voxels != Voxels::directional)
        throw Error("the preset thesis has no light to bake; use mobile or quality");
    if (settings_.cascades > 1)
        throw Error(
            "with cascades, voxels and their light follow the camera, so that there is nothing to bake; "
            "leave out the voxel size and the number of cascades");
}

std::vector<BakedLight::Face> Renderer::bakeLight() const {
    requireBakeable();
    const DirectionalVolume* volume = directional();
    const Irradiance* light = volume != nullptr ? volume->irradiance() : nullptr;
    if (light == nullptr || !light->isConverged())
        throw Error(
            "the light has not converged, so it cannot be baked; render a picture of converged "
            "indirect light before");
    if (isLightChanged_)
        throw Error(
            "light can be baked for the scene as it was described, but lights, sky or materials "
            "were changed since; describe the scene with them");
    return light->bake(volume->voxels());
}

void Renderer::useBakedLight(BakedLight light) {
    requireBakeable();
    if (directional() != nullptr && directional()->irradiance() != nullptr)
        throw Error(
            "baked light comes too late, because the renderer has computed light already; give it "
            "before the first picture");
    bakedLight_ = std::make_shared<const BakedLight>(std::move(light));
}

shared::FrameUniforms Renderer::uploadFrameUniforms(const Camera& camera, const Cascades& last) {
    shared::FrameUniforms values = frameUniforms(camera, light_, radianceUnit_, boundsWorld_, volume_,
                                                 settings_, scene_.boundsWith(boundsWorld_));
    if (pictureShift_ != glm::vec2(0.0F)) {
        const glm::vec3 ndc(2.0F * pictureShift_ / glm::vec2(settings_.size), 0.0F);
        values.clipFromVolume = glm::translate(glm::mat4(1.0F), ndc) * values.clipFromVolume;
        values.volumeFromWindow = glm::translate(values.volumeFromWindow, -glm::vec3(pictureShift_, 0.0F));
    }
    setCascades(values, cascades_, last, light_, boundsWorld_, volume_, settings_);
    values.faceSumUnits = faceSumUnits(triangles_);
    values.emissionRange = emissionRange_;
    values.hasDynamicObjects = scene_.moves() || (settings_.revoxelize && settings_.cascades == 1) ? 1 : 0;
    frameUniforms_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof values, &values);
    frameUniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
    if (environment_) environment_->bind(VCT_TEX_ENVIRONMENT);
    if (emitters_) emitters_->bind();
    return values;
}

void Renderer::invalidateCaches() {
    if (shadowMap_) shadowMap_->invalidate();
    if (punctualLights_) punctualLights_->invalidate();
    if (voxels_) voxels_->invalidate();
}

void Renderer::applyPose(const Pose& pose) {
    scene_.setPose(pose);
    if (punctualLights_) punctualLights_->setPose(pose);
    if (emitters_) emitters_->setPose(pose);
}

SceneState Renderer::state() const {
    return {scene_.placements(), light_.directionToLight,
            punctualLights_ ? punctualLights_->states() : std::vector<PunctualLightState>(), skyChanges_,
            lightChanges_};
}

LightFeatures Renderer::lightFeatures() const {
    return {punctualLights_.has_value(), settings_.environment != nullptr, emitters_ ? emitters_->words() : 0,
            hasEmission_, softLights_};
}

GBuffer& Renderer::gBuffer() {
    if (!gBuffer_)
        gBuffer_.emplace(shaders_, scene_, settings_.size, extraTargets(scene_.features(), settings_.voxels));
    return *gBuffer_;
}

ShadowMap& Renderer::shadowMap() {
    if (!shadowMap_)
        shadowMap_.emplace(shaders_, scene_, settings_.shadowMapSize, settings_.voxels == Voxels::directional,
                           settings_.cascades);
    return *shadowMap_;
}

VoxelVolume& Renderer::voxels() {
    if (voxels_) return *voxels_;
    const bool packed = settings_.voxels == Voxels::packed;
    if (texturesInMainMemory_)
        requireMemory(voxelBytes(settings_, settings_.grid),
                      "the voxels at " + std::to_string(settings_.grid) + "^3");
    if (packed)
        voxels_ = std::make_unique<PackedVolume>(shaders_, scene_, settings_, voxelization_);
    else
        voxels_ =
            std::make_unique<DirectionalVolume>(shaders_, scene_, settings_, pixelSamples_, lightFeatures());
    return *voxels_;
}

bool Renderer::hasLight() const {
    const DirectionalVolume* volume = directional();
    return volume == nullptr ? voxels_ != nullptr : volume->irradiance() != nullptr;
}

LightProgress Renderer::lightProgress() const {
    const DirectionalVolume* volume = directional();
    const Irradiance* light = volume != nullptr ? volume->irradiance() : nullptr;
    if (light == nullptr) return {};
    return {light->stepsToConverge() - light->stepsLeft(), light->stepsToConverge()};
}

float Renderer::radianceScale() const {
    return radianceUnit_;
}

Image Renderer::radiance() const {
    return readImage(output(), radianceUnit_);
}

std::vector<std::string> Renderer::lookUpDefines() const {
    GatherSettings few;
    few.directions = lookUpDirections;
    const LightFeatures lights = lightFeatures();
    std::vector<std::string> defines = shaders_.defines;
    for (const std::vector<std::string>& more :
         {gatherDefines(few), lightDefines(lights), emissionDefines(lights.emission)})
        defines.insert(defines.end(), more.begin(), more.end());
    return defines;
}

LookUpInputs Renderer::lookUpInputs() const {
    const DirectionalVolume* volume = directional();
    const Irradiance* light = volume != nullptr ? volume->irradiance() : nullptr;
    if (light == nullptr || !light->holdsLight())
        throw Error(
            "the look-up has no light yet; use the preset mobile or quality, and request a picture with "
            "indirect light before");
    const DirectionalVoxels& voxels = volume->voxels();
    // Pages have the index of cascades.
    const gl::Texture* index = voxels.cascades() == 1 ? &voxels.staticIndex() : nullptr;
    return {{index, &voxels.dynamicIndex(), &voxels.dynamicPages(), &voxels.blocks(), light->bricks(),
             light->brickPlaces(), light->walls(), environment_ ? &*environment_ : nullptr},
            {&frameUniforms_, emitters_ ? &emitters_->uniforms() : nullptr},
            &voxels.faceData()};
}

std::vector<std::uint32_t> Renderer::activeVoxels() const {
    return voxels_ ? voxels_->occupancy().readActiveCounts() : std::vector<std::uint32_t>();
}

Resources Renderer::resources() const {
    Resources resources = scene_.resources();
    add(resources, frameUniforms_);
    if (environment_) add(resources, *environment_);
    if (emitters_) add(resources, emitters_->uniforms());
    if (shadowMap_) add(resources, shadowMap_->texture());
    if (punctualLights_) add(resources, punctualLights_->resources());
    if (gBuffer_) add(resources, gBuffer_->resources());
    if (voxels_) add(resources, voxels_->resources());
    for (const Shade& shade : shades_)
        add(resources, shade.resources());
    return resources;
}

}  // namespace vct
