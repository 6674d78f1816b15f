#include "render/renderer.h"

#include <algorithm>
#include <utility>

#include "core/memory.h"
#include "gl/debug.h"
#include "render/frame_uniforms.h"
#include "render/programs.h"
#include "render/read_back.h"
#include "render/stage_view.h"
#include "render/voxel_view.h"

namespace vct {

namespace {

const Settings& validated(const Settings& settings) {
    validate(settings);
    return settings;
}

bool needsShadowMap(Mode mode) {
    return mode != Mode::phong;
}
bool needsVoxels(Mode mode) {
    return mode == Mode::ao || mode == Mode::gi || mode == Mode::giConeShadow;
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
      gBuffer_(shaders_, scene_, settings.size, extraTargets(scene_.needs(), settings.specular)),
      coneTracer_(shaders_, settings),
      // A driver on the CPU has no other clock, and draws an empty picture for each query: .1 ms and more.
      timer_(capabilities.softwareDriver ? 0 : capabilities.gpuTimerBits) {
    if (settings.voxelization == Voxelization::geometryShader)
        capabilities.require("GL_EXT_geometry_shader", "--voxelization sorted-axes gives the same voxels");
    if (scene_.moves() && settings.voxels == Voxels::faces) {
        capabilities.require("GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES >= 8", "--preset thesis does without");
        if (settings.bounces > 0) capabilities.require("GL_EXT_copy_image", "--bounces 0 does without it");
    }
    gl::checkErrors("setting up the renderer");
}

void Renderer::frame(Mode mode, const Camera& camera) {
    // Occlusion asks for no light.
    draw(mode, camera, mode == Mode::ao ? 0 : settings_.bounces);
}

void Renderer::draw(Mode mode, const Camera& camera, int bounces) {
    timer_.beginFrame();
    // Given back at the end: where something throws, nothing counts as made.
    Made made = std::exchange(made_, {});
    // Sorting triangles by their axis takes the longest of it.
    if (nextPose_) timer_.timeOnCpu(Step::voxelize, [&] { scene_.setPose(*nextPose_); });
    nextPose_.reset();
    if (settings_.revoxelize) made = {};
    const Lit lit{scene_.placements(), light_.towardsLight};
    uploadFrameUniforms(camera);
    ShadowMap* const shadowPass = needsShadowMap(mode) ? &shadowMap() : nullptr;
    const bool words = needsVoxels(mode) && settings_.voxels == Voxels::words;
    const bool faces = needsVoxels(mode) && settings_.voxels == Voxels::faces;
    WordPasses* const wordPass = words ? &wordPasses() : nullptr;
    FacePasses* const facePass = faces ? &facePasses() : nullptr;

    const gl::Texture* const shadow = shadowPass ? &shadowPass->texture() : nullptr;
    if (shadowPass && made.shadowMap != lit) {
        timer_.time(Step::shadowMap, [&] { shadowPass->draw(scene_); });
        made.shadowMap = lit;
    }
    const auto surface = timer_.time(Step::renderData, [&] { return gBuffer_.draw(scene_); });
    const bool makeVoxels = made.voxels != lit || made.bounces != bounces;
    ConeTracer::Light light;
    if (wordPass) {
        if (makeVoxels) makeWords(made.voxels);
        light.voxels = &wordPass->pyramid.texture();
    }
    if (facePass) {
        FaceVoxels& voxels = facePass->voxels;
        if (makeVoxels) makeFaces(made, bounces);
        light.faces = &voxels.faces();
        light.gather =
            timer_.time(Step::trace, [&] { return gather(static_cast<int>(mode)).draw(surface, voxels); });
    }
    if (words || faces) {
        made.voxels = lit;
        made.bounces = bounces;
    }
    timer_.time(Step::trace, [&] { coneTracer_.draw(static_cast<int>(mode), surface, shadow, light); });
    timer_.endFrame();
    gl::checkErrors(std::string("frame, mode ") + modeName(mode));
    made_ = made;
}

// Of the present pose and light; `before`: those of the voxels that there are.
void Renderer::makeWords(const std::optional<Lit>& before) {
    WordPasses& passes = wordPasses();
    const gl::Texture& shadow = shadowMap().texture();
    if (before && before->placements == scene_.placements()) {
        if (!passes.relighter) passes.relighter.emplace(shaders_, scene_, settings_.voxelization);
        timer_.time(Step::voxelize,
                    [&] { passes.relighter->run(scene_, shadow, passes.voxelizer, passes.pyramid); });
        timer_.time(Step::mipmap, [&] { passes.relighter->mipmap(passes.pyramid); });
        return;
    }
    if (!passes.partial) {
        timer_.time(Step::voxelize, [&] { passes.voxelizer.run(scene_, shadow, passes.pyramid); });
        timer_.time(Step::mipmap, [&] { passes.mipmapper.run(passes.pyramid); });
        return;
    }
    timer_.time(Step::voxelize, [&] {
        const std::optional<BlockMask> changed = changedSince(before);
        passes.partial->voxelize(scene_, shadow, changed ? &*changed : nullptr, passes.voxelizer,
                                 passes.mipmapper, passes.pyramid);
    });
    timer_.time(Step::mipmap, [&] { passes.partial->mipmap(passes.pyramid); });
}

// Likewise, with `bounces`.
void Renderer::makeFaces(const Made& before, int bounces) {
    FacePasses& passes = facePasses();
    FaceVoxels& voxels = passes.voxels;
    const gl::Texture& shadow = shadowMap().texture();
    FaceBounces* const bouncePass = bounces > 0 ? &faceBounces() : nullptr;
    const bool sameSurfaces = before.voxels && before.voxels->placements == scene_.placements();
    if (sameSurfaces && !passes.relighter)
        passes.relighter.emplace(shaders_, scene_, settings_.grid, settings_.voxelization,
                                 settings_.voxelSamples);
    if (sameSurfaces) {
        timer_.time(Step::voxelize, [&] { passes.relighter->run(scene_, shadow, voxels); });
        timer_.time(Step::mipmap, [&] { passes.mipmapper.update(voxels, 1); });
    } else if (!passes.partial) {
        timer_.time(Step::voxelize, [&] { passes.voxelizer.run(scene_, shadow, voxels); });
        timer_.time(Step::mipmap, [&] { passes.mipmapper.makeLevels(voxels); });
    } else {
        std::optional<BlockMask> changed;
        bool room = false;
        while (!room) {
            timer_.time(Step::voxelize, [&] {
                if (before.bounces == bounces) changed = changedSince(before.voxels);
                passes.partial->voxelize(scene_, shadow, changed ? &*changed : nullptr, bouncePass,
                                         passes.voxelizer, passes.mipmapper, voxels);
            });
            timer_.time(Step::mipmap, [&] { room = passes.partial->mipmap(voxels); });
        }
    }
    timer_.time(Step::bounces, [&] {
        if (!bouncePass) return;
        if (sameSurfaces && before.bounces > 0)
            bouncePass->runAgain(shaders_, bounces, voxels, passes.mipmapper);
        else
            bouncePass->run(bounces, voxels, passes.mipmapper);
    });
}

// Which blocks what moves can have changed since; nothing where that is not known, or they can all have.
std::optional<BlockMask> Renderer::changedSince(const std::optional<Lit>& before) const {
    if (!before || before->towardsLight != light_.towardsLight) return {};
    const double diagonal = glm::length(boundsWorld_.max - boundsWorld_.min);
    // The filter reads the texels around a point: two would do.
    const double margin = 4.0 * diagonal / settings_.shadowMapSize / volume_.side;
    return changedBlocks(before->placements, scene_.placements(),
                         {light_.towardsLight, margin, scene_.stillBox()}, 1.0 / settings_.grid);
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
    if (!shadowMap_) shadowMap_.emplace(shaders_, scene_, settings_.shadowMapSize);
    return *shadowMap_;
}

Renderer::WordPasses& Renderer::wordPasses() {
    if (!wordPasses_) {
        if (texturesInMainMemory_)
            requireMemory(VoxelPyramid::bytesFor(settings_.grid, settings_.activeVoxelLimit),
                          "the voxels at " + std::to_string(settings_.grid) + "^3");
        wordPasses_.emplace(WordPasses{
            VoxelPyramid(shaders_, settings_.grid, settings_.activeVoxelLimit),
            Voxelizer(shaders_, scene_, settings_.grid, settings_.voxelization, settings_.voxelSamples),
            Mipmapper(shaders_, mipmapperProgram()),
            {},
            {}});
        if (scene_.moves()) wordPasses_->partial.emplace(shaders_, scene_, settings_.voxelization);
    }
    return *wordPasses_;
}

Renderer::FacePasses& Renderer::facePasses() {
    if (!facePasses_) {
        if (texturesInMainMemory_)
            requireMemory(FaceVoxels::bytesFor(settings_.grid, settings_.activeVoxelLimit),
                          "the voxels at " + std::to_string(settings_.grid) + "^3");
        facePasses_.emplace(FacePasses{
            FaceVoxels(shaders_, settings_.grid, settings_.activeVoxelLimit),
            FaceVoxelizer(shaders_, scene_, settings_.grid, settings_.voxelization, settings_.voxelSamples),
            FaceMipmapper(shaders_),
            {},
            {},
            {},
            {},
            {}});
        if (scene_.moves()) facePasses_->partial.emplace(shaders_, scene_, settings_.voxelization);
    }
    return *facePasses_;
}

FaceBounces& Renderer::faceBounces() {
    FacePasses& passes = facePasses();
    if (!passes.bounces) passes.bounces.emplace(shaders_, settings_.grid, scene_.moves());
    return *passes.bounces;
}

Gather& Renderer::gather(int modeOrView) {
    FacePasses& passes = facePasses();
    const bool occlusion = modeOrView == VCT_MODE_AO || modeOrView == VCT_VIEW_AO;
    std::optional<Gather>& pass = occlusion ? passes.occlusion : passes.light;
    if (!pass)
        pass.emplace(shaders_, occlusion ? settings_.occlusion : settings_.gather,
                     occlusion ? GatherOf::occlusion : GatherOf::light, settings_.size);
    return *pass;
}

// Which voxels are occupied, of either kind.
const VoxelPyramid& Renderer::occupancy() {
    return settings_.voxels == Voxels::words ? wordPasses().pyramid : facePasses().voxels.slots();
}

void Renderer::uploadFrameUniforms(const Camera& camera) {
    shared::FrameUniforms values =
        frameUniforms(camera, light_, boundsWorld_, volume_, settings_, scene_.boundsWith(boundsWorld_));
    values.faces.x = faceSumUnits(triangles_, settings_.voxelSamples);
    values.faces.y = faceRadianceRange_;
    values.faces.z = largestBounceShare_;
    frameUniforms_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof values, &values);
    frameUniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
}

Image Renderer::radiance() const {
    return readImage(coneTracer_.texture(), radianceUnit(light_));
}

Image Renderer::tracedView(int view) {
    const GBuffer::Targets surface = gBuffer_.targets();
    ConeTracer::Light light;
    if (settings_.voxels == Voxels::words)
        light.voxels = &wordPasses().pyramid.texture();
    else {
        light.faces = &facePasses().voxels.faces();
        light.gather = gather(view).draw(surface, facePasses().voxels);
    }
    return readImage(coneTracer_.draw(view, surface, &shadowMap().texture(), light));
}

std::vector<Renderer::Stage> Renderer::lightParts(const Camera& camera) {
    draw(Mode::giConeShadow, camera, 0);
    Image indirect = tracedView(VCT_VIEW_INDIRECT);
    for (glm::vec3& p : indirect.pixels)
        p *= radianceUnit(light_);
    std::vector<Stage> parts;
    parts.push_back({"ambient_occlusion", tracedView(VCT_VIEW_AO), true});
    parts.push_back({"indirect_light", std::move(indirect), true});
    parts.push_back({"cone_shadow", tracedView(VCT_VIEW_CONE_SHADOW), true});
    if (gBuffer_.targets().gloss != nullptr) {
        draw(Mode::giConeShadow, camera, settings_.bounces);
        Image specular = tracedView(VCT_VIEW_SPECULAR);
        for (glm::vec3& p : specular.pixels)
            p *= radianceUnit(light_);
        parts.push_back({"specular_light", std::move(specular), true});
    }
    gl::checkErrors("light parts");
    return parts;
}

std::vector<Renderer::Stage> Renderer::stages(const Camera& camera) {
    frame(Mode::giConeShadow, camera);
    const GBuffer::Targets surface = gBuffer_.targets();
    std::vector<Stage> stages;

    surface.albedo->bind(VCT_TEX_G_ALBEDO);
    surface.normal->bind(VCT_TEX_G_NORMAL);
    surface.depth->bind(VCT_TEX_G_DEPTH);
    const gl::Texture& shadow = shadowMap().texture();
    shadow.bind(VCT_TEX_SHADOW_MAP);
    // Read as a picture, not compared.
    shadow.setParameter(GL_TEXTURE_COMPARE_MODE, GL_NONE);
    const glm::ivec2 shadowSize(settings_.shadowMapSize);
    stages.push_back(
        {"shadow_map", stretchDepth(drawStage(shaders_, VCT_STAGE_SHADOW_MAP, shadowSize)), false});
    shadow.setParameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);

    stages.push_back({"g_buffer_albedo", drawStage(shaders_, VCT_STAGE_ALBEDO, settings_.size), true});
    stages.push_back({"g_buffer_normal", drawStage(shaders_, VCT_STAGE_NORMAL, settings_.size), false});
    stages.push_back(
        {"g_buffer_depth", stretchDepth(drawStage(shaders_, VCT_STAGE_DEPTH, settings_.size)), false});
    if (surface.emissive != nullptr) {
        surface.emissive->bind(VCT_TEX_G_EMISSIVE);
        stages.push_back(
            {"g_buffer_emissive", drawStage(shaders_, VCT_STAGE_EMISSIVE, settings_.size), false});
    }

    VoxelView voxelView(shaders_, settings_.size);
    const VoxelPyramid& pyramid = occupancy();
    for (int level = 0; level < pyramid.levels(); ++level)
        stages.push_back(
            {"voxels_level_" + std::to_string(level), readImage(voxelView.draw(pyramid, level)), false});

    for (Stage& part : lightParts(camera))
        stages.push_back(std::move(part));
    gl::checkErrors("stage pictures");
    return stages;
}

std::vector<std::uint32_t> Renderer::activeVoxels() const {
    if (wordPasses_) return wordPasses_->pyramid.readActiveCounts();
    if (facePasses_) return facePasses_->voxels.slots().readActiveCounts();
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
    if (wordPasses_) {
        addPyramid(wordPasses_->pyramid);
        if (wordPasses_->partial)
            for (const gl::Buffer* buffer : wordPasses_->partial->buffers())
                add(*buffer);
    }
    if (facePasses_) {
        addPyramid(facePasses_->voxels.slots());
        add(facePasses_->voxels.faces());
        add(facePasses_->voxels.sums());
        if (facePasses_->partial)
            for (const gl::Buffer* buffer : facePasses_->partial->buffers())
                add(*buffer);
        if (facePasses_->bounces) {
            add(facePasses_->bounces->patches());
            if (facePasses_->bounces->direct() != nullptr) add(*facePasses_->bounces->direct());
        }
        for (const std::optional<Gather>* gather : {&facePasses_->light, &facePasses_->occlusion})
            if (*gather)
                for (const gl::Texture* texture : (*gather)->textures())
                    add(*texture);
    }
    add(coneTracer_.texture());
    return resources;
}

}  // namespace vct
