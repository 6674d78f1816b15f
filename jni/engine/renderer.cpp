#include "engine/renderer.h"

#include <algorithm>
#include <utility>

#include "core/memory.h"
#include "engine/frame_uniforms.h"
#include "engine/programs.h"
#include "gl/debug.h"
#include "lab/debug_view.h"
#include "lab/read_back.h"
#include "lab/voxel_view.h"

namespace vct {

namespace {

const Settings& validated(const Settings& settings) {
    validate(settings);
    return settings;
}

bool needsShadowMap(int modeOrView) {
    return modeOrView != VCT_MODE_PHONG;
}
bool needsShadowLevels(int modeOrView, const Settings& settings) {
    return settings.shadow == Shadow::softMap &&
           (modeOrView == VCT_MODE_GI_CONE_SHADOW || modeOrView == VCT_VIEW_CONE_SHADOW);
}
bool needsVoxels(int modeOrView) {
    return modeOrView >= VCT_MODE_AO;
}
bool isOcclusion(int modeOrView) {
    return modeOrView == VCT_MODE_AO || modeOrView == VCT_VIEW_AO;
}
bool isIndirectLight(int modeOrView) {
    return needsVoxels(modeOrView) && !isOcclusion(modeOrView) && modeOrView != VCT_VIEW_CONE_SHADOW;
}

}  // namespace

Settings forDriver(Settings settings, const gl::Capabilities& capabilities) {
    if (!capabilities.meets("GL_EXT_geometry_shader")) settings.voxelization = Voxelization::sortedAxes;
    return settings;
}

Renderer::Renderer(const Scene& scene, const DirectionalLight& light, const Settings& settings,
                   const gl::Capabilities& capabilities, gl::ReadShader readShader)
    : settings_(validated(settings)),
      texturesInMainMemory_(capabilities.texturesInMainMemory),
      shaders_(shaderLibrary(settings, capabilities, std::move(readShader))),
      light_(light),
      boundsWorld_(scene.boundsWorld),
      triangles_(scene.triangleCount()),
      faceRadianceRange_(faceRadianceRange(scene, light, settings.skyRadiance)),
      largestBounceShare_(largestBounceShare(scene)),
      volume_(volumeAround(scene.boundsWorld, settings.grid)),
      scene_(scene, volume_, radianceUnit(light), capabilities.uniformBufferOffsetAlignment,
             settings.voxelization),
      frameUniforms_("frame uniforms", GL_UNIFORM_BUFFER, sizeof(shared::FrameUniforms), nullptr,
                     GL_DYNAMIC_DRAW),
      gBuffer_(shaders_, scene_, settings.size, extraTargets(scene_.features(), settings.specular)),
      shade_(shaders_, settings),
      // A driver on the CPU has no other clock, and draws an empty picture for each query: .1 ms and more.
      timer_(capabilities.softwareDriver ? 0 : capabilities.gpuTimerBits) {
    if (settings.voxelization == Voxelization::geometryShader)
        capabilities.require("GL_EXT_geometry_shader", "--voxelization sorted-axes gives the same voxels");
    if (scene_.moves() && settings.voxels == Voxels::directional)
        capabilities.require("GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES >= 8", "--preset thesis does without");
    gl::checkErrors("setting up the renderer");
}

void Renderer::frame(Mode mode, const Camera& camera) {
    draw(static_cast<int>(mode), camera, 1);
}

void Renderer::renderConverged(Mode mode, const Camera& camera) {
    draw(static_cast<int>(mode), camera, settings_.lightFrames);
}

void Renderer::draw(int modeOrView, const Camera& camera, int lightSteps, bool allBounces) {
    timer_.beginFrame();
    // Given back at the end: where something throws, nothing counts as made.
    Made made = std::exchange(made_, {});
    // Sorting triangles by their axis takes the longest of it.
    if (nextPose_) timer_.timeOnCpu(Step::voxelize, [&] { scene_.setPose(*nextPose_); });
    nextPose_.reset();
    const Lit lit{scene_.placements(), light_.towardsLight};
    const bool makeVoxels = settings_.revoxelize || made.voxels != lit;
    uploadFrameUniforms(camera);
    ShadowMap* const shadowPass = needsShadowMap(modeOrView) ? &shadowMap() : nullptr;
    const bool voxels = needsVoxels(modeOrView);
    PackedPasses* const packedPass = voxels && settings_.voxels == Voxels::packed ? &packedPasses() : nullptr;
    DirectionalPasses* const directionalPass =
        voxels && settings_.voxels == Voxels::directional ? &directionalPasses() : nullptr;

    const gl::Texture* const shadow = shadowPass ? &shadowPass->texture() : nullptr;
    if (shadowPass && (settings_.revoxelize || made.shadowMap != lit)) {
        timer_.time(Step::shadowMap, [&] { shadowPass->draw(scene_); });
        made.shadowMap = lit;
        made.shadowLevels = false;
    }
    if (shadowPass && needsShadowLevels(modeOrView, settings_) && !std::exchange(made.shadowLevels, true))
        timer_.time(Step::shadowMap, [&] { shadowPass->makeLevels(); });
    const auto surface = timer_.time(Step::renderData, [&] { return gBuffer_.draw(scene_); });
    Shade::Light light;
    if (packedPass) {
        if (makeVoxels) updatePacked();
        light.voxels = &packedPass->pyramid.texture();
    }
    if (directionalPass) {
        if (makeVoxels) updateDirectional(made.voxels, lit);
        light.faces = &directionalPass->voxels.faces();
    }
    if (directionalPass && (isOcclusion(modeOrView) || isIndirectLight(modeOrView))) {
        Irradiance& received = irradiance(modeOrView);
        if (!isOcclusion(modeOrView)) {
            if (made.allBounces != allBounces) received.forget();
            made.allBounces = allBounces;
        }
        timer_.time(Step::irradiance, [&] {
            for (int i = 0; i < lightSteps && !received.settled(); ++i)
                received.step(directionalPass->voxels, directionalPass->mipmapper, allBounces);
        });
        light.irradiance = received.irradiance();
        light.bricks = received.bricks();
    }
    if (voxels) made.voxels = lit;
    timer_.time(Step::trace, [&] { shade_.draw(modeOrView, surface, shadow, light); });
    timer_.endFrame();
    gl::checkErrors("frame, mode or view " + std::to_string(modeOrView));
    made_ = made;
}

// The thesis made its voxels anew for each frame; here only when light or pose have changed.
void Renderer::updatePacked() {
    PackedPasses& passes = packedPasses();
    const gl::Texture& shadow = shadowMap().texture();
    timer_.time(Step::voxelize, [&] { passes.voxelizer.run(scene_, shadow, passes.pyramid); });
    timer_.time(Step::mipmap, [&] { passes.mipmapper.run(passes.pyramid); });
}

// Of the present pose and light, `now`; `before`: those of the faces that there are.
void Renderer::updateDirectional(const std::optional<Lit>& before, const Lit& now) {
    DirectionalPasses& passes = directionalPasses();
    DirectionalVoxels& voxels = passes.voxels;
    const gl::Texture& shadow = shadowMap().texture();
    Irradiance::Change change{std::nullopt, before != now};
    if (before && before->placements == now.placements && !settings_.revoxelize) {
        if (!passes.relighter)
            passes.relighter.emplace(shaders_, scene_, settings_.grid, settings_.voxelization);
        timer_.time(Step::voxelize, [&] { passes.relighter->run(scene_, shadow, voxels); });
        timer_.time(Step::mipmap, [&] { passes.mipmapper.update(voxels, 0); });
    } else if (!passes.partial) {
        timer_.time(Step::voxelize, [&] { passes.voxelizer.run(scene_, shadow, voxels); });
        timer_.time(Step::mipmap, [&] { passes.mipmapper.makeLevels(voxels); });
        change.keptFaces = 0U;
    } else {
        bool room = false;
        while (!room) {
            timer_.time(Step::voxelize, [&] {
                const std::optional<BlockMask> changed =
                    settings_.revoxelize ? std::nullopt : changedSince(before);
                passes.partial->voxelize(scene_, shadow, changed ? &*changed : nullptr, passes.voxelizer,
                                         passes.mipmapper, voxels);
            });
            timer_.time(Step::mipmap, [&] { room = passes.partial->mipmap(voxels); });
            change.keptFaces = std::min(change.keptFaces.value_or(VCT_NO_ENTRY), passes.partial->keptFaces());
        }
    }
    for (std::optional<Irradiance>* irradiance : {&passes.light, &passes.occlusion})
        if (*irradiance) (*irradiance)->note(change);
}

// Which blocks what moves can have changed since; nothing where that is not known, or they can all have.
std::optional<BlockMask> Renderer::changedSince(const std::optional<Lit>& before) const {
    if (!before || before->towardsLight != light_.towardsLight) return {};
    const double diagonal = glm::length(boundsWorld_.max - boundsWorld_.min);
    const double texel = diagonal / settings_.shadowMapSize / volume_.side;
    // The filter reads three texels to each side of a point at most. Those of faces are compared with the
    // surface's plane where they are, which may rise by 64 times as much (shaders/shared/shadow.glsl).
    const double above = settings_.voxels == Voxels::directional ? 3.0 * 64.0 * texel : 0.0;
    return dirtyBlocks(before->placements, scene_.placements(),
                       {light_.towardsLight, 4.0 * texel, above, scene_.staticBox()}, 1.0 / settings_.grid);
}

void Renderer::setLightDirection(const glm::dvec3& towardsLight) {
    light_.towardsLight = towardsLight;
}

void Renderer::setShadowConeAngle(float degrees) {
    Settings changed = settings_;
    changed.shadowConeAngleDeg = degrees;
    validate(changed);
    settings_ = changed;
}

float Renderer::radianceScale() const {
    return radianceUnit(light_);
}

ShadowMap& Renderer::shadowMap() {
    if (!shadowMap_)
        shadowMap_.emplace(shaders_, scene_, settings_.shadowMapSize, shadowMapLevels(settings_));
    return *shadowMap_;
}

Renderer::PackedPasses& Renderer::packedPasses() {
    if (!packedPasses_) {
        if (texturesInMainMemory_)
            requireMemory(VoxelPyramid::bytesFor(settings_.grid, settings_.activeVoxelLimit),
                          "the voxels at " + std::to_string(settings_.grid) + "^3");
        packedPasses_.emplace(
            PackedPasses{VoxelPyramid(shaders_, settings_.grid, settings_.activeVoxelLimit),
                         PackedVoxelizer(shaders_, scene_, settings_.grid, settings_.voxelization),
                         PackedMipmapper(shaders_)});
    }
    return *packedPasses_;
}

Renderer::DirectionalPasses& Renderer::directionalPasses() {
    if (!directionalPasses_) {
        if (texturesInMainMemory_)
            requireMemory(DirectionalVoxels::bytesFor(settings_.grid, settings_.activeVoxelLimit),
                          "the voxels at " + std::to_string(settings_.grid) + "^3");
        directionalPasses_.emplace(
            DirectionalPasses{DirectionalVoxels(shaders_, settings_.grid, settings_.activeVoxelLimit),
                              DirectionalVoxelizer(shaders_, scene_, settings_.grid, settings_.voxelization),
                              DirectionalMipmapper(shaders_),
                              {},
                              {},
                              {},
                              {}});
        if (scene_.moves()) directionalPasses_->partial.emplace(shaders_, scene_, settings_.voxelization);
    }
    return *directionalPasses_;
}

Irradiance& Renderer::irradiance(int modeOrView) {
    DirectionalPasses& passes = directionalPasses();
    const bool occlusion = isOcclusion(modeOrView);
    std::optional<Irradiance>& pass = occlusion ? passes.occlusion : passes.light;
    if (!pass)
        pass.emplace(shaders_, occlusion ? settings_.occlusion : settings_.gather,
                     occlusion ? GatherOf::occlusion : GatherOf::light, settings_.lightFrames,
                     scene_.moves());
    return *pass;
}

// Which voxels are occupied, of either kind.
const VoxelPyramid& Renderer::occupancy() {
    return settings_.voxels == Voxels::packed ? packedPasses().pyramid : directionalPasses().voxels.index();
}

void Renderer::uploadFrameUniforms(const Camera& camera) {
    shared::FrameUniforms values =
        frameUniforms(camera, light_, boundsWorld_, volume_, settings_, scene_.boundsWith(boundsWorld_));
    values.faces.x = faceSumUnits(triangles_);
    values.faces.y = faceRadianceRange_;
    values.faces.z = largestBounceShare_;
    frameUniforms_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof values, &values);
    frameUniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
}

Image Renderer::radiance() const {
    return readImage(shade_.texture(), radianceUnit(light_));
}

Image Renderer::view(int view, const Camera& camera, bool allBounces) {
    draw(view, camera, settings_.lightFrames, allBounces);
    return readImage(shade_.texture());
}

std::vector<Renderer::DebugView> Renderer::lightParts(const Camera& camera) {
    const auto inUnits = [this](Image image) {
        for (glm::vec3& p : image.pixels)
            p *= radianceUnit(light_);
        return image;
    };
    std::vector<DebugView> parts;
    parts.push_back({"ambient_occlusion", view(VCT_VIEW_AO, camera, true), true});
    parts.push_back({"indirect_light", inUnits(view(VCT_VIEW_INDIRECT, camera, false)), true});
    parts.push_back({"cone_shadow", view(VCT_VIEW_CONE_SHADOW, camera, true), true});
    if (gBuffer_.targets().gloss != nullptr)
        parts.push_back({"specular_light", inUnits(view(VCT_VIEW_SPECULAR, camera, true)), true});
    return parts;
}

std::vector<Renderer::DebugView> Renderer::debugViews(const Camera& camera) {
    renderConverged(Mode::giConeShadow, camera);
    const GBuffer::Targets surface = gBuffer_.targets();
    std::vector<DebugView> views;

    surface.albedo->bind(VCT_TEX_G_ALBEDO);
    surface.normal->bind(VCT_TEX_G_NORMAL);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    const gl::Texture& shadow = shadowMap().texture();
    shadow.bind(VCT_TEX_SHADOW_MAP);
    // Read as a picture, not compared.
    shadow.setParameter(GL_TEXTURE_COMPARE_MODE, GL_NONE);
    const glm::ivec2 shadowSize(settings_.shadowMapSize);
    views.push_back(
        {"shadow_map", stretchDepth(drawDebugView(shaders_, VCT_DEBUG_VIEW_SHADOW_MAP, shadowSize)), false});
    shadow.setParameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);

    views.push_back(
        {"g_buffer_albedo", drawDebugView(shaders_, VCT_DEBUG_VIEW_ALBEDO, settings_.size), true});
    views.push_back(
        {"g_buffer_normal", drawDebugView(shaders_, VCT_DEBUG_VIEW_NORMAL, settings_.size), false});
    views.push_back({"g_buffer_depth",
                     stretchDepth(drawDebugView(shaders_, VCT_DEBUG_VIEW_DEPTH, settings_.size)), false});
    if (surface.emissive != nullptr) {
        surface.emissive->bind(VCT_TEX_G_EMISSIVE);
        views.push_back(
            {"g_buffer_emissive", drawDebugView(shaders_, VCT_DEBUG_VIEW_EMISSIVE, settings_.size), false});
    }

    VoxelView voxelView(shaders_, settings_.size);
    const VoxelPyramid& pyramid = occupancy();
    for (int level = 0; level < pyramid.levels(); ++level)
        views.push_back(
            {"voxels_level_" + std::to_string(level), readImage(voxelView.draw(pyramid, level)), false});

    for (DebugView& part : lightParts(camera))
        views.push_back(std::move(part));
    gl::checkErrors("debug views");
    return views;
}

std::vector<std::uint32_t> Renderer::activeVoxels() const {
    if (packedPasses_) return packedPasses_->pyramid.readActiveCounts();
    if (directionalPasses_) return directionalPasses_->voxels.index().readActiveCounts();
    return {};
}

std::vector<Renderer::Resource> Renderer::resources() const {
    std::vector<Resource> resources;
    const auto add = [&](const auto& object) { resources.push_back({object.label(), object.bytes()}); };
    for (const gl::Buffer* buffer : scene_.buffers())
        add(*buffer);
    std::size_t textureBytes = 0;
    for (const gl::Texture* texture : scene_.textures())
        textureBytes += texture->bytes();
    if (textureBytes > 0) resources.push_back({"scene textures", textureBytes});
    add(frameUniforms_);
    if (shadowMap_) add(shadowMap_->texture());
    const GBuffer::Targets surface = gBuffer_.targets();
    for (const gl::Texture* target :
         {surface.albedo, surface.normal, surface.emissive, surface.gloss, surface.depth})
        if (target != nullptr) add(*target);
    const auto addPyramid = [&](const VoxelPyramid& pyramid) {
        add(pyramid.texture());
        add(pyramid.activeVoxels());
        add(pyramid.commands());
    };
    if (packedPasses_) addPyramid(packedPasses_->pyramid);
    if (directionalPasses_) {
        addPyramid(directionalPasses_->voxels.index());
        add(directionalPasses_->voxels.faces());
        add(directionalPasses_->voxels.sums());
        if (directionalPasses_->partial)
            for (const gl::Buffer* buffer : directionalPasses_->partial->buffers())
                add(*buffer);
        for (const std::optional<Irradiance>* irradiance :
             {&directionalPasses_->light, &directionalPasses_->occlusion}) {
            if (!*irradiance) continue;
            add((*irradiance)->received());
            for (const gl::Texture* texture : (*irradiance)->textures())
                add(*texture);
        }
    }
    add(shade_.texture());
    return resources;
}

}  // namespace vct
