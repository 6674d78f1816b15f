#include "vct/vct.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "api/embedded_shaders.h"
#include "api/look_up.h"
#include "api/saved_state.h"
#include "api/scene_of.h"
#include "engine/environment.h"
#include "engine/grid_choice.h"
#include "engine/renderer.h"
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
    if (!(options.voxelSize >= 0.0F)) throw Error("Options::voxelSize must be 0 or above");
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
using CurrentContext = void* (*)();
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
glm::dmat4 projectionOf(const Matrix& matrix) {
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
    if (result[perspective ? 3 : 2][2] > 0.0)
        throw Error("View::clipFromCamera reverses depth; give a projection whose depth grows with distance");
    return result;
}

Camera cameraOf(const View& view) {
    const glm::dmat4 cameraFromWorld = affine(view.cameraFromWorld, "View::cameraFromWorld");
    const glm::dmat3 axes(cameraFromWorld);
    const glm::dmat3 product = glm::transpose(axes) * axes;
    for (int i = 0; i < 3; ++i)
        if (glm::length(product[i] - glm::dmat3(1.0)[i]) > 1e-4 || glm::determinant(axes) < 0.0)
            throw Error(
                "View::cameraFromWorld is not a rotation and a translation; leave out scale and mirroring");
    Camera camera;
    camera.worldFromCamera = glm::inverse(cameraFromWorld);
    camera.clipFromWorld = projectionOf(view.clipFromCamera) * cameraFromWorld;
    return camera;
}

struct TextureParameters {
    GLint width = 0, height = 0, format = 0;
};

// `member`: the member of the interface that has this name. Throws vct::Error if it is not a texture.
TextureParameters requireTexture(unsigned name, const std::string& member) {
    gl::Texture::wrapExternal(name).bind(gl::scratchTextureUnit);
    TextureParameters found;
    if (name != 0) {
        gl::GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &found.width);
        gl::GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &found.height);
        gl::GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &found.format);
    }
    if (gl::GetError() != GL_NO_ERROR || found.width < 1)
        throw Error(member + " is " + std::to_string(name) +
                    ", which is not a 2D texture with storage; give the name of one");
    return found;
}

// Throws vct::Error if a texture of the caller's G-buffer has the wrong size or format.
void requireTarget(unsigned name, const char* what, glm::ivec2 size, std::initializer_list<GLint> formats) {
    const std::string member = std::string("GBufferTextures::") + what;
    const TextureParameters found = requireTexture(name, member);
    if (found.width != size.x || found.height != size.y)
        throw Error(member + " has " + std::to_string(found.width) + "x" + std::to_string(found.height) +
                    " texels, but the pictures have " + std::to_string(size.x) + "x" +
                    std::to_string(size.y) + "; give it that size, or call resize()");
    if (std::find(formats.begin(), formats.end(), found.format) == formats.end())
        throw Error(member + " has the internal format " + std::to_string(found.format) +
                    "; use one of the formats that vct.h lists");
}

// Throws vct::Error if the buffer has not so many vertices.
ExternalVertices::Attribute attributeOf(unsigned buffer, std::size_t offset, std::size_t stride,
                                        std::size_t vertices, const char* member) {
    const std::string name = std::string("VertexBuffers::") + member;
    if (offset % 4 != 0 || stride % 4 != 0 || stride < 12)
        throw Error(name + ": give offset and stride in bytes, multiples of 4, and a stride of 12 or more");
    GLint bytes = 0;
    if (gl::IsBuffer(buffer) != GL_FALSE) {
        gl::BindBuffer(GL_COPY_READ_BUFFER, buffer);
        gl::GetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
    }
    const std::size_t needed = offset + stride * (vertices - 1) + 12;
    if (static_cast<std::size_t>(bytes) < needed)
        throw Error(name + " is " + std::to_string(buffer) + ", a buffer of " + std::to_string(bytes) +
                    " bytes (0: there is none), and " + std::to_string(vertices) + " vertices need " +
                    std::to_string(needed));
    return {buffer, offset / 4, stride / 4};
}

void requireTextures(const std::vector<MaterialDescription>& materials) {
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const std::string material = "material " + std::to_string(i);
        for (const auto& [name, member] : {std::pair{materials[i].baseColorTexture, ": baseColorTexture"},
                                           {materials[i].emissionTexture, ": emissionTexture"}})
            if (name != 0) requireTexture(name, material + member);
    }
}

}  // namespace

struct GlobalIllumination::Implementation {
    Implementation(GetProcAddress getProcAddress, const SceneDescription& description, const Options& options)
        : Implementation(sceneOf(description), description, options, capabilitiesOf(getProcAddress)) {
        currentContext = currentContextOf(getProcAddress);
        context = currentContext != nullptr ? currentContext() : nullptr;
    }

    Implementation(const Scene& scene, const SceneDescription& description, const Options& options,
                   const gl::Capabilities& capabilities)
        : outputs(outputsFor(options)) {
        hasLight.resize(scene.punctualLights.size() + scene.punctualLightRoom);
        std::fill_n(hasLight.begin(), scene.punctualLights.size(), true);
        for (const Mesh& mesh : scene.meshes)
            meshes.push_back(
                {mesh.deformation ? mesh.deformation->joints[0].node : -1, mesh.vertices.size()});
        for (const Instance& instance : scene.instances) {
            nodes.push_back(instance.node);
            if (instance.moves()) pose.worldFromNode.push_back(instance.worldFromObject);
        }
        const SavedState saved;
        requireTextures(description.materials);
        renderer.emplace(scene, scene.lights.front(), settingsOf(options, description, scene.boundsWorld),
                         capabilities, shadersOf(options));
        plain.emplace();
        appearances.resize(pose.worldFromNode.size());
        for (std::size_t i = 0; i < description.instances.size(); ++i)
            if (!description.instances[i].isVisible)
                setAppearance(nodeOf(i, "isVisible = false"), false, 1.0F);
    }
    ~Implementation() {
        const SavedState saved;
        plain.reset();
        renderer.reset();
    }

    // True if the context is current that the objects of GL belong to, as far as the window system can be
    // asked.
    bool isContextCurrent() const {
        return currentContext != nullptr ? currentContext() == context : gl::GetString(GL_VERSION) != nullptr;
    }

    void requireContext(const std::string& function) const {
        if (isContextCurrent()) return;
        const bool none = currentContext != nullptr ? currentContext() == nullptr : true;
        throw Error(function +
                    (none ? ": no GL context is current in this thread"
                          : ": another GL context is current in this thread") +
                    "; make the one current with which the GlobalIllumination was created");
    }

    unsigned textureOf(Output output) const {
        const auto found = std::find(outputs.begin(), outputs.end(), output);
        return found == outputs.end()
                   ? 0
                   : renderer->output(static_cast<std::size_t>(found - outputs.begin())).name();
    }

    // The node of an instance that moves.
    int nodeOf(std::size_t instance, const char* function) const {
        const std::string name = "instance " + std::to_string(instance);
        if (instance >= nodes.size())
            throw Error(std::string(function) + ": there is no " + name + "; the scene has " +
                        std::to_string(nodes.size()) + " instances");
        if (nodes[instance] < 0)
            throw Error(std::string(function) + ": " + name +
                        " was not declared to move; set InstanceDescription::moves");
        return nodes[instance];
    }

    void setAppearance(int node, bool isVisible, float emission) {
        appearances[static_cast<std::size_t>(node)] = {isVisible, emission};
        renderer->setAppearance(node, isVisible, emission);
    }

    void requireLight(std::size_t number, const char* function) const {
        if (number >= hasLight.size() || !hasLight[number])
            throw Error(std::string(function) + ": there is no light " + std::to_string(number) +
                        "; give a number that addLight() returned, or an index of SceneDescription::lights");
    }

    Pictures render(const View& view, Light light, const GBuffer::Targets* surface) {
        renderer->render({outputs, cameraOf(view),
                          light == Light::converged ? LightSteps::all : LightSteps::one, surface});
        return {textureOf(Output::giConeShadow), textureOf(Output::irradiance),
                textureOf(Output::ambientVisibility), textureOf(Output::sunVisibility),
                textureOf(Output::specularLight)};
    }

    CurrentContext currentContext = nullptr;
    void* context = nullptr;
    std::vector<Output> outputs;
    struct DeformingMesh {
        int node;  // -1: it does not deform
        std::size_t vertices;
    };
    std::vector<DeformingMesh> meshes;
    std::vector<int> nodes;  // by instance; -1: it does not move
    Pose pose;
    struct Appearance {
        bool isVisible = true;
        float emission = 1.0F;
    };
    std::vector<Appearance> appearances;  // by node
    std::vector<bool> hasLight;           // by number; false: there is room for one
    std::optional<Renderer> renderer;
    std::optional<gl::PlainSampler> plain;  // reads the caller's G-buffer
};

namespace {

// The implementation of an object for a call of a function, which must be possible.
template <class Implementation>
Implementation& ready(const std::unique_ptr<Implementation>& implementation, const char* function) {
    if (implementation == nullptr)
        throw Error(std::string(function) +
                    ": this GlobalIllumination was moved from; call the one that it was moved to");
    implementation->requireContext(function);
    return *implementation;
}

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
    const std::vector<Implementation::DeformingMesh>& meshes = implementation.meshes;
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
    if (gBuffer.emission != 0) requireTarget(gBuffer.emission, "emission", size, {GL_RGBA16F});
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

std::string GlobalIllumination::lookUpGlsl(const LookUpBindings& bindings) const {
    Implementation& implementation = ready(implementation_, "lookUpGlsl");
    const Renderer& renderer = *implementation.renderer;
    if (renderer.settings().voxels != Voxels::directional)
        throw Error("lookUpGlsl: the preset thesis has no look-up; use mobile or quality");
    std::vector<std::string> defines = renderer.lookUpDefines();
    unsigned unit = bindings.firstTextureUnit, buffer = bindings.firstUniformBuffer;
    for (const char* name : {"VOXELS", "DYNAMIC_VOXELS", "BLOCKS", "IRRADIANCE", "BRICKS", "WALLS", "SKY"})
        defines.push_back("VCT_LOOK_UP_" + (name + (" " + std::to_string(unit++))));
    for (const char* name : {"FRAME", "EMITTERS"})
        defines.push_back("VCT_LOOK_UP_" + (name + (" " + std::to_string(buffer++))));
    defines.push_back("VCT_LOOK_UP_FACES " + std::to_string(bindings.storageBuffer));
    return embeddableGlsl(renderer.shaders().read, "directional/look_up.glsl", defines, "irradianceAt");
}

void GlobalIllumination::bindLookUp(const LookUpBindings& bindings) const {
    Implementation& implementation = ready(implementation_, "bindLookUp");
    const LookUpInputs inputs = implementation.renderer->lookUpInputs();
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
