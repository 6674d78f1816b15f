#include "vct/vct.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "api/caller_objects.h"
#include "api/embedded_shaders.h"
#include "api/implementation.h"
#include "api/look_up.h"
#include "api/saved_state.h"
#include "api/scene_of.h"
#include "core/number_text.h"
#include "engine/environment.h"
#include "engine/grid_choice.h"
#include "shared/layout.h"

namespace vct {

namespace {

std::shared_ptr<const Environment> environmentOf(const SkyPicture& sky) {
    const std::size_t pixels = sky.radiance.size() / 3;
    if (sky.width < 1 || sky.height < 1 || sky.radiance.size() % 3 != 0 ||
        pixels != static_cast<std::size_t>(sky.width) * static_cast<std::size_t>(sky.height))
        throw Error("SceneDescription::sky: give three numbers for each of its width x height pixels");
    Image image(sky.width, sky.height);
    for (std::size_t i = 0; i < pixels; ++i)
        image.pixels[i] = {sky.radiance[3 * i], sky.radiance[3 * i + 1], sky.radiance[3 * i + 2]};
    return std::make_shared<const Environment>(image, "SceneDescription::sky");
}

glm::vec3 skyRadianceOf(const std::array<float, 3>& radiance) {
    for (const float component : radiance)
        if (!(component >= 0.0F && component <= 1e30F))
            throw Error("the sky's radiance: give numbers between 0 and 1e30");
    return {radiance[0], radiance[1], radiance[2]};
}

Settings settingsOf(const Options& options, const SceneDescription& scene, const Bounds& boundsWorld) {
    Settings settings = presetSettings(options.preset);
    if (options.grid != 0) settings.grid = options.grid;
    if (!(options.voxelSize >= 0.0F && std::isfinite(options.voxelSize)))
        throw Error("Options::voxelSize must be 0 or above, in metres");
    if (options.voxelSize > 0.0F) {
        const GridChoice choice = chooseForVoxelSize(boundsWorld, settings, double{options.voxelSize});
        settings.grid = choice.grid;
        settings.cascades = choice.cascades;
    }
    settings.size = {options.width, options.height};
    settings.shadowConeAngleDeg = scene.sun.diameterDegrees;
    settings.skyRadiance = skyRadianceOf(scene.skyRadiance);
    if (scene.sky) settings.environment = environmentOf(*scene.sky);
    return settings;
}

gl::Capabilities capabilitiesOf(GetProcAddress getProcAddress) {
    if (getProcAddress == nullptr)
        throw Error("getProcAddress is null; give the function that returns the addresses of GL functions");
    gl::load(
        [](const char* name, const void* user) {
            return reinterpret_cast<gl::Proc>((*static_cast<const GetProcAddress*>(user))(name));
        },
        &getProcAddress);
    gl::Capabilities capabilities = gl::queryCapabilities();
    capabilities.requireAll();
    return capabilities;
}

// The window system's function that returns the current context; null if getProcAddress does not know it.
// Call it while a context is current.
CurrentContext currentContextOf(GetProcAddress getProcAddress) {
    for (const char* name : {"eglGetCurrentContext", "glXGetCurrentContext"}) {
        const auto current = reinterpret_cast<CurrentContext>(getProcAddress(name));
        if (current != nullptr && current() != nullptr) return current;
    }
    return nullptr;
}

gl::ReadShader shadersOf(const Options& options) {
    return options.shaderFolder.empty() ? embeddedShaders() : gl::shadersFromFolder(options.shaderFolder);
}

std::vector<Output> outputsFor(const Options& options) {
    std::vector<Output> outputs;
    if (options.radiance) outputs.push_back(Output::giConeShadow);
    if (options.irradiance) outputs.push_back(Output::irradiance);
    if (options.ambientVisibility) outputs.push_back(Output::ambientVisibility);
    if (options.sunVisibility) outputs.push_back(Output::sunVisibility);
    if (options.specular) outputs.push_back(Output::specularLight);
    if (outputs.empty())
        throw Error(
            "the options ask for no picture; set radiance, irradiance, ambientVisibility, sunVisibility or "
            "specular");
    return outputs;
}

// Checks the last row of a projection, to reject transposed matrices, which would give a wrong picture
// without an error. The tolerance allows for rounding in matrix products.
glm::dmat4 projectionOf(const Matrix& matrix, bool reversedDepth) {
    glm::dmat4 result;
    for (int i = 0; i < 16; ++i)
        result[i / 4][i % 4] = matrix.columns[i];
    const double volume = glm::determinant(result);
    if (volume == 0.0 || !std::isfinite(volume))
        throw Error("View::clipFromCamera has no inverse; give a projection matrix");
    const glm::dvec4 lastRow(result[0][3], result[1][3], result[2][3], result[3][3]);
    const auto endsWith = [&](const glm::dvec4& row) { return glm::length(lastRow - row) < 1e-4; };
    const bool perspective = endsWith({0, 0, -1, 0});
    if (!perspective && !endsWith({0, 0, 0, 1}))
        throw Error(
            "View::clipFromCamera is not a projection: its last row must be 0 0 -1 0 (perspective) or 0 0 0 "
            "1 "
            "(orthographic); matrices are in column-major order");
    const bool isReversed = result[perspective ? 3 : 2][2] > 0.0;
    if (isReversed && !reversedDepth)
        throw Error(
            "View::clipFromCamera reverses depth; set View::reversedDepth, or give a projection whose "
            "depth grows with distance");
    if (!isReversed && reversedDepth)
        throw Error(
            "View::reversedDepth is set, but depth by View::clipFromCamera grows with distance; give "
            "a projection with depth from 1 (near) to 0 (far)");
    return result;
}

// `ownSurface`: the engine draws the G-buffer, whose depth it need not reverse.
Camera cameraOf(const View& view, bool ownSurface) {
    const glm::dmat4 cameraFromWorld = affine(view.cameraFromWorld, "View::cameraFromWorld");
    const glm::dmat3 axes(cameraFromWorld);
    const glm::dmat3 product = glm::transpose(axes) * axes;
    for (int i = 0; i < 3; ++i)
        if (glm::length(product[i] - glm::dmat3(1.0)[i]) > 1e-4 || glm::determinant(axes) < 0.0)
            throw Error(
                "View::cameraFromWorld is not a rotation and a translation; leave out scale and mirroring");
    Camera camera;
    camera.worldFromCamera = glm::inverse(cameraFromWorld);
    camera.clipFromWorld = projectionOf(view.clipFromCamera, view.reversedDepth) * cameraFromWorld;
    camera.reversedDepth = view.reversedDepth && !ownSurface;
    if (view.reversedDepth && ownSurface) {
        // From [1, 0] to [-1, 1].
        glm::dmat4 usualFromReversed(1.0);
        usualFromReversed[2][2] = -2.0;
        usualFromReversed[3][2] = 1.0;
        camera.clipFromWorld = usualFromReversed * *camera.clipFromWorld;
    }
    return camera;
}

// Reports programs, and keeps them where the embedding program wants that.
gl::ProgramHooks hooksOf(const Options& options) {
    gl::ProgramHooks hooks;
    hooks.load = options.loadProgram;
    if (options.storeProgram)
        hooks.store = [store = options.storeProgram](const std::string& key,
                                                     const std::vector<std::uint8_t>& binary) {
            store(key, binary);
        };
    if (options.log || options.progress)
        hooks.onLinked = [log = options.log, progress = options.progress, count = 0](
                             const std::string& name, double ms, bool isLoaded) mutable {
            if (log)
                log((isLoaded ? "loaded" : "compiled") + (" the program " + name) + " in " + numberText(ms) +
                    " ms");
            if (progress) progress({"programs", ++count, 0});
        };
    return hooks;
}

}  // namespace

GlobalIllumination::Implementation::Implementation(GetProcAddress getProcAddress,
                                                   const SceneDescription& description,
                                                   const Options& options)
    : outputs(outputsFor(options)), onProgress(options.progress) {
    const Scene scene = sceneOf(description);
    const gl::Capabilities capabilities = capabilitiesOf(getProcAddress);
    currentContext = currentContextOf(getProcAddress);
    context = currentContext != nullptr ? currentContext() : nullptr;

    hasLight.resize(scene.punctualLights.size() + scene.punctualLightRoom);
    std::fill_n(hasLight.begin(), scene.punctualLights.size(), true);
    materials.assign(scene.materials.begin(), scene.materials.end());
    describedMaterials = materials.size();
    textures = scene.textures;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const MeshDescription& mesh = description.meshes[i];
        const std::shared_ptr<const Deformation>& deformation = scene.meshes[i].deformation;
        meshes.push_back({.material = mesh.material,
                          .vertices = scene.meshes[i].vertices.size(),
                          .hasColors = !mesh.colors.empty(),
                          .hasTextureCoordinates = !mesh.textureCoordinates.empty(),
                          .deforms = mesh.deforms,
                          .node = deformation ? deformation->joints[0].node : -1});
    }
    for (const Instance& instance : scene.instances) {
        instances.push_back({.mesh = static_cast<std::size_t>(instance.mesh), .node = instance.node});
        if (instance.moves()) pose.worldFromNode.push_back(instance.worldFromObject);
    }
    describedInstances = instances.size();
    maxInstances = describedInstances + scene.instanceRoom;
    const SavedState saved;
    for (std::size_t i = 0; i < description.materials.size(); ++i)
        requireTextures(description.materials[i], "material " + std::to_string(i));
    const Settings settings = settingsOf(options, description, scene.boundsWorld);
    if (options.log) {
        options.log(capabilities.renderer + ", " + capabilities.version);
        options.log(gridText(scene.boundsWorld, settings.grid, settings.cascades));
        for (const std::string& note :
             {voxelizationNote(settings.voxels, capabilities), coarseGridWarning(scene, settings)})
            if (!note.empty()) options.log(note);
    }
    lightKey = vct::lightKey(scene, scene.lights.front(), settings);
    renderer.emplace(scene, scene.lights.front(), settings, capabilities, shadersOf(options),
                     std::make_shared<gl::ProgramCache>(hooksOf(options)));
    plain.emplace();
    appearances.resize(pose.worldFromNode.size());
    for (std::size_t i = 0; i < description.instances.size(); ++i)
        if (!description.instances[i].isVisible) setAppearance(nodeOf(i, "isVisible = false"), false, 1.0F);
}

GlobalIllumination::Implementation::~Implementation() {
    const SavedState saved;
    plain.reset();
    renderer.reset();
}

bool GlobalIllumination::Implementation::isContextCurrent() const {
    return currentContext != nullptr ? currentContext() == context : gl::GetString(GL_VERSION) != nullptr;
}

void GlobalIllumination::Implementation::requireContext(const std::string& function) const {
    if (isContextCurrent()) return;
    const bool none = currentContext != nullptr ? currentContext() == nullptr : true;
    throw Error(function +
                (none ? ": no GL context is current in this thread"
                      : ": another GL context is current in this thread") +
                "; make the one current with which the GlobalIllumination was created");
}

unsigned GlobalIllumination::Implementation::textureOf(Output output) const {
    const auto found = std::find(outputs.begin(), outputs.end(), output);
    return found == outputs.end()
               ? 0
               : renderer->output(static_cast<std::size_t>(found - outputs.begin())).name();
}

void GlobalIllumination::Implementation::requireInstance(std::size_t instance, const char* function) const {
    if (instance < instances.size() && instances[instance].exists) return;
    const auto count = std::count_if(instances.begin(), instances.end(),
                                     [](const InstanceState& state) { return state.exists; });
    throw Error(std::string(function) + ": there is no instance " + std::to_string(instance) +
                "; the scene has " + std::to_string(count) + " instances");
}

int GlobalIllumination::Implementation::nodeOf(std::size_t instance, const char* function) const {
    requireInstance(instance, function);
    if (instances[instance].node < 0)
        throw Error(std::string(function) + ": instance " + std::to_string(instance) +
                    " was not declared to move; set InstanceDescription::moves");
    return instances[instance].node;
}

void GlobalIllumination::Implementation::setAppearance(int node, bool isVisible, float emission) {
    appearances[static_cast<std::size_t>(node)] = {isVisible, emission};
    renderer->setAppearance(node, isVisible, emission);
}

void GlobalIllumination::Implementation::requireLight(std::size_t number, const char* function) const {
    if (number >= hasLight.size() || !hasLight[number])
        throw Error(std::string(function) + ": there is no light " + std::to_string(number) +
                    "; give a number that addLight() returned, or an index of SceneDescription::lights");
}

Pictures GlobalIllumination::Implementation::render(const View& view, Light light,
                                                    const GBuffer::Targets* surface) {
    RenderRequest request{
        .outputs = outputs, .camera = cameraOf(view, surface == nullptr), .surface = surface};
    request.lightSteps = light == Light::converged ? LightSteps::all
                         : light == Light::keep    ? LightSteps::none
                                                   : LightSteps::one;
    if (onProgress && light == Light::converged)
        request.onLightStep = [this](int done, int total) { onProgress({"light", done, total}); };
    stepTimes.clear();
    if (measures) renderer->timer().startRecording(Clocks::cpu);
    try {
        renderer->render(request);
    } catch (...) {
        if (measures) renderer->timer().stopRecording();
        throw;
    }
    if (measures) {
        const StepTimes times = renderer->timer().stopRecording();
        for (int i = 0; i < stepCount; ++i)
            if (const std::vector<double>& ms = times.stepMs[static_cast<std::size_t>(i)]; !ms.empty())
                stepTimes.push_back({stepName(static_cast<Step>(i)), ms.back()});
    }
    return {textureOf(Output::giConeShadow), textureOf(Output::irradiance),
            textureOf(Output::ambientVisibility), textureOf(Output::sunVisibility),
            textureOf(Output::specularLight)};
}

namespace {

// Deletes what an object owns. Without its context it is leaked: GL would delete objects of another context,
// or crash.
template <class Implementation>
void destroy(std::unique_ptr<Implementation>& implementation) {
    if (implementation != nullptr && !implementation->isContextCurrent())
        static_cast<void>(implementation.release());
    implementation.reset();
}

}  // namespace

GlobalIllumination::GlobalIllumination(GetProcAddress getProcAddress, const SceneDescription& scene,
                                       const Options& options)
    : implementation_(std::make_unique<Implementation>(getProcAddress, scene, options)) {}

GlobalIllumination::~GlobalIllumination() {
    destroy(implementation_);
}
GlobalIllumination::GlobalIllumination(GlobalIllumination&&) noexcept = default;
GlobalIllumination& GlobalIllumination::operator=(GlobalIllumination&& other) noexcept {
    if (this == &other) return *this;
    destroy(implementation_);
    implementation_ = std::move(other.implementation_);
    return *this;
}

void GlobalIllumination::setTransform(std::size_t instance, const Matrix& worldFromObject) {
    Implementation& implementation = ready(implementation_, "setTransform");
    const int node = implementation.nodeOf(instance, "setTransform");
    implementation.pose.worldFromNode[static_cast<std::size_t>(node)] =
        affine(worldFromObject, "setTransform: the transform of instance " + std::to_string(instance));
    implementation.renderer->setPose(implementation.pose);
}

void GlobalIllumination::setVertices(std::size_t mesh, const VertexBuffers& vertices, const Box& bounds) {
    Implementation& implementation = ready(implementation_, "setVertices");
    const std::vector<Implementation::MeshState>& meshes = implementation.meshes;
    if (mesh >= meshes.size() || meshes[mesh].node < 0)
        throw Error("setVertices: mesh " + std::to_string(mesh) +
                    " does not exist or was not declared to deform; set MeshDescription::deforms");
    const SavedState saved;
    implementation.renderer->setVertices(
        meshes[mesh].node,
        {attributeOf(vertices.positions, vertices.positionOffset, vertices.positionStride,
                     meshes[mesh].vertices, "positions"),
         attributeOf(vertices.normals, vertices.normalOffset, vertices.normalStride, meshes[mesh].vertices,
                     "normals"),
         {{bounds.min[0], bounds.min[1], bounds.min[2]}, {bounds.max[0], bounds.max[1], bounds.max[2]}}});
}

void GlobalIllumination::setVisible(std::size_t instance, bool isVisible) {
    Implementation& implementation = ready(implementation_, "setVisible");
    const int node = implementation.nodeOf(instance, "setVisible");
    const SavedState saved;
    implementation.setAppearance(node, isVisible,
                                 implementation.appearances[static_cast<std::size_t>(node)].emission);
}

void GlobalIllumination::setEmission(std::size_t instance, float scale) {
    Implementation& implementation = ready(implementation_, "setEmission");
    const int node = implementation.nodeOf(instance, "setEmission");
    if (!(scale >= 0.0F && scale <= 1.0F)) throw Error("setEmission: give a scale between 0 and 1");
    const SavedState saved;
    implementation.setAppearance(node, implementation.appearances[static_cast<std::size_t>(node)].isVisible,
                                 scale);
}

void GlobalIllumination::setSun(const std::array<double, 3>& directionToSun) {
    Implementation& implementation = ready(implementation_, "setSun");
    implementation.renderer->setLightDirection(direction(directionToSun, "setSun: the direction"));
}

void GlobalIllumination::setSunlight(const std::array<float, 3>& color, float illuminance) {
    Implementation& implementation = ready(implementation_, "setSunlight");
    Sun sun;
    sun.color = color;
    sun.illuminance = illuminance;
    const DirectionalLight light = lightOf(sun);
    implementation.renderer->setSunlight(light.color, light.intensity);
}

void GlobalIllumination::setSky(const std::array<float, 3>& radiance) {
    Implementation& implementation = ready(implementation_, "setSky");
    if (implementation.renderer->settings().environment)
        throw Error("setSky: the scene was described with a picture of the sky; give a picture");
    implementation.renderer->setSky(skyRadianceOf(radiance));
}

void GlobalIllumination::setSky(const SkyPicture& picture) {
    Implementation& implementation = ready(implementation_, "setSky");
    if (!implementation.renderer->settings().environment)
        throw Error("setSky: the scene was described without a picture of the sky; describe it with one");
    const std::shared_ptr<const Environment> environment = environmentOf(picture);
    const SavedState saved;
    implementation.renderer->setSky(environment);
}

std::size_t GlobalIllumination::addLight(const LightDescription& light) {
    Implementation& implementation = ready(implementation_, "addLight");
    std::vector<bool>& hasLight = implementation.hasLight;
    const auto free = std::find(hasLight.begin(), hasLight.end(), false);
    if (free == hasLight.end())
        throw Error("addLight: the scene has " + std::to_string(hasLight.size()) +
                    " lights already; remove one, or raise SceneDescription::maxLights");
    const auto number = static_cast<std::size_t>(free - hasLight.begin());
    implementation.renderer->setPunctualLight(number, lightOf(light, "addLight"));
    *free = true;
    return number;
}

void GlobalIllumination::setLight(std::size_t number, const LightDescription& light) {
    Implementation& implementation = ready(implementation_, "setLight");
    implementation.requireLight(number, "setLight");
    implementation.renderer->setPunctualLight(number, lightOf(light, "setLight"));
}

void GlobalIllumination::removeLight(std::size_t number) {
    Implementation& implementation = ready(implementation_, "removeLight");
    implementation.requireLight(number, "removeLight");
    implementation.renderer->setPunctualLight(number, std::nullopt);
    implementation.hasLight[number] = false;
}

void GlobalIllumination::resize(int width, int height) {
    Implementation& implementation = ready(implementation_, "resize");
    const SavedState saved;
    implementation.renderer->resize({width, height});
}

Pictures GlobalIllumination::render(const View& view, Light light) {
    Implementation& implementation = ready(implementation_, "render");
    const SavedState saved;
    return implementation.render(view, light, nullptr);
}

Pictures GlobalIllumination::render(const View& view, const GBufferTextures& gBuffer, Light light) {
    Implementation& implementation = ready(implementation_, "render");
    const SavedState saved;
    const glm::ivec2 size = implementation.renderer->settings().size;
    requireTarget(gBuffer.albedo, "albedo", size, {GL_RGBA8});
    requireTarget(gBuffer.normal, "normal", size, {GL_RG16UI});
    requireTarget(gBuffer.depth, "depth", size, {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT24});
    if (gBuffer.emission != 0)
        requireTarget(gBuffer.emission, "emission", size, {GL_RGBA16F, GL_R11F_G11F_B10F});
    if (gBuffer.gloss != 0) requireTarget(gBuffer.gloss, "gloss", size, {GL_RG8});
    for (const int unit : {VCT_TEX_G_ALBEDO, VCT_TEX_G_NORMAL, VCT_TEX_G_DEPTH, VCT_TEX_G_EMISSIVE})
        implementation.plain->bind(unit);
    const auto albedo = gl::Texture::wrapExternal(gBuffer.albedo),
               normal = gl::Texture::wrapExternal(gBuffer.normal),
               depth = gl::Texture::wrapExternal(gBuffer.depth),
               emission = gl::Texture::wrapExternal(gBuffer.emission),
               gloss = gl::Texture::wrapExternal(gBuffer.gloss);
    const GBuffer::Targets surface{
        &albedo, &normal, gBuffer.emission != 0 ? &emission : nullptr, gBuffer.gloss != 0 ? &gloss : nullptr,
        &depth,  false};
    return implementation.render(view, light, &surface);
}

std::vector<std::uint8_t> GlobalIllumination::bakeLight() const {
    Implementation& implementation = ready(implementation_, "bakeLight");
    const SavedState saved;
    try {
        return bytesOf({implementation.lightKey, implementation.renderer->bakeLight()});
    } catch (const Error& error) {
        throw Error(std::string("bakeLight: ") + error.what());
    }
}

void GlobalIllumination::useBakedLight(std::span<const std::uint8_t> baked) {
    Implementation& implementation = ready(implementation_, "useBakedLight");
    implementation.renderer->useBakedLight(
        bakedLightOf(baked, implementation.lightKey, "useBakedLight: this"));
}

void GlobalIllumination::measureSteps(bool measures) {
    ready(implementation_, "measureSteps").measures = measures;
}

std::vector<StepTime> GlobalIllumination::stepTimes() const {
    return ready(implementation_, "stepTimes").stepTimes;
}

Progress GlobalIllumination::lightProgress() const {
    const LightProgress steps = ready(implementation_, "lightProgress").renderer->lightProgress();
    return {"light", steps.done, steps.total};
}

namespace {

void checkBindings(const std::string& function, const LookUpBindings& bindings) {
    struct Places {
        const char* kind;
        std::uint64_t first, count;
        GLenum limit;
    };
    for (const Places& places :
         {Places{"texture units", bindings.firstTextureUnit, 8, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS},
          Places{"uniform buffers", bindings.firstUniformBuffer, 2, GL_MAX_UNIFORM_BUFFER_BINDINGS},
          Places{"storage buffers", bindings.storageBuffer, 1, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS}}) {
        GLint limit = 0;
        gl::GetIntegerv(places.limit, &limit);
        if (places.first + places.count > static_cast<std::uint64_t>(limit))
            throw Error(function + ": LookUpBindings names " + places.kind + " " +
                        std::to_string(places.first) + " to " +
                        std::to_string(places.first + places.count - 1) + ", and the driver has " +
                        std::to_string(limit) + ", counted from 0; name lower ones");
    }
}

}  // namespace

std::string GlobalIllumination::lookUpGlsl(const LookUpBindings& bindings) const {
    Implementation& implementation = ready(implementation_, "lookUpGlsl");
    const Renderer& renderer = *implementation.renderer;
    if (renderer.settings().voxels != Voxels::directional)
        throw Error("lookUpGlsl: the preset thesis has no look-up; use mobile or quality");
    checkBindings("lookUpGlsl", bindings);
    std::vector<std::string> defines = renderer.lookUpDefines();
    unsigned unit = bindings.firstTextureUnit, buffer = bindings.firstUniformBuffer;
    for (const char* name :
         {"VOXELS", "DYNAMIC_VOXELS", "DYNAMIC_PAGES", "BLOCKS", "BRICKS", "BRICK_PLACES", "WALLS", "SKY"})
        defines.push_back("VCT_LOOK_UP_" + (name + (" " + std::to_string(unit++))));
    for (const char* name : {"FRAME", "EMITTERS"})
        defines.push_back("VCT_LOOK_UP_" + (name + (" " + std::to_string(buffer++))));
    defines.push_back("VCT_LOOK_UP_FACES " + std::to_string(bindings.storageBuffer));
    return embeddableGlsl(renderer.shaders().read, "directional/look_up.glsl", defines, "irradianceAt");
}

void GlobalIllumination::bindLookUp(const LookUpBindings& bindings) const {
    Implementation& implementation = ready(implementation_, "bindLookUp");
    const LookUpInputs inputs = implementation.renderer->lookUpInputs();
    checkBindings("bindLookUp", bindings);
    GLint activeUnit = 0, generic = 0, storage = 0;
    gl::GetIntegerv(GL_ACTIVE_TEXTURE, &activeUnit);
    gl::GetIntegerv(GL_UNIFORM_BUFFER_BINDING, &generic);
    gl::GetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &storage);
    for (GLuint i = 0; i < inputs.textures.size(); ++i) {
        if (inputs.textures[i] == nullptr) continue;
        inputs.textures[i]->bind(static_cast<int>(bindings.firstTextureUnit + i));
        gl::BindSampler(bindings.firstTextureUnit + i, 0);
    }
    for (GLuint i = 0; i < inputs.uniforms.size(); ++i)
        if (inputs.uniforms[i] != nullptr)
            inputs.uniforms[i]->bindBase(GL_UNIFORM_BUFFER, bindings.firstUniformBuffer + i);
    inputs.faces->bindBase(GL_SHADER_STORAGE_BUFFER, bindings.storageBuffer);
    gl::ActiveTexture(static_cast<GLenum>(activeUnit));
    gl::BindBuffer(GL_UNIFORM_BUFFER, static_cast<GLuint>(generic));
    gl::BindBuffer(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(storage));
}

double GlobalIllumination::radianceUnit() const {
    Implementation& implementation = ready(implementation_, "radianceUnit");
    return implementation.renderer->radianceScale();
}

Box GlobalIllumination::voxelBounds() const {
    Implementation& implementation = ready(implementation_, "voxelBounds");
    const Volume& volume = implementation.renderer->volume();
    const glm::dvec3 min = volume.minWorld, max = min + volume.side;
    return {{min.x, min.y, min.z}, {max.x, max.y, max.z}};
}

gl::ReadShader embeddedShaders() {
    return [](const std::string& path) {
        for (const EmbeddedFile* file = embeddedFiles; file->path != nullptr; ++file)
            if (path == file->path) return std::string(file->text);
        throw Error("the shader " + path + " is not in the library; build the library again");
    };
}

std::string normalEncodingGlsl() {
    return embeddedShaders()("shared/normals.glsl") + embeddedShaders()("shared/face_normal.glsl");
}

}  // namespace vct
