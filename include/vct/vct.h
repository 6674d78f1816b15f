// Global illumination by voxel cone tracing, for programs with an OpenGL ES 3.1 context that has image
// atomics (part of the Android Extension Pack), or with desktop OpenGL 4.5. docs/embedding.md is an
// introduction.
//
// Conventions: world space is right-handed, +Y up, in metres. Colours are linear RGB (Rec. 709 primaries).
// Radiance is absolute, in the unit of the sun's illuminance per steradian. Matrices are column-major and
// multiply column vectors from the left, as in GL and glm.
//
// All functions of GlobalIllumination need the GL context that it was created with to be current, and throw
// vct::Error if none or another is, as far as EGL or GLX can tell. Every message names cause and remedy. An
// object that was moved from throws, too. An object that is destroyed without its context keeps its objects
// of GL until the context is destroyed. No two threads may call functions of an object at the same time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "vct/error.h"
#include "vct/version.h"

namespace vct {

struct Matrix {
    std::array<double, 16> columns{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    // Converts sixteen floats or doubles, for example Matrix::of(glm::value_ptr(m)).
    template <class Number>
    static Matrix of(const Number* sixteen) {
        Matrix matrix;
        for (std::size_t i = 0; i < 16; ++i)
            matrix.columns[i] = static_cast<double>(sixteen[i]);
        return matrix;
    }
};

struct Box {
    std::array<double, 3> min, max;
};

struct MaterialDescription {
    std::array<float, 3> baseColor{1, 1, 1};  // 0 to 1
    std::array<float, 3> emission{0, 0, 0};   // radiance, not negative
    // Metallic-roughness as in glTF 2.0, both 0 to 1. With the presets mobile and quality a metal, or another
    // surface with a roughness below 1, is glossy.
    float metallic = 0.0F;
    float roughness = 1.0F;
    // False: the triangles are invisible from behind, but cast shadows from both sides.
    bool doubleSided = false;
    // Names of 2D textures that multiply baseColor and emission; 0: none. Their filters and wrap modes apply,
    // and sampling must give linear colours, as with GL_SRGB8_ALPHA8. They must exist as long as the
    // GlobalIllumination, with the same content.
    unsigned baseColorTexture = 0, emissionTexture = 0;
    // As in glTF: green multiplies roughness and blue metallic; and a normal map in tangent space, whose x
    // and y are multiplied by normalScale. Only the library's own G-buffer reads them.
    unsigned glossTexture = 0, normalTexture = 0;
    float normalScale = 1.0F;
    // Above 0, there are holes where alpha is less, which is the texture's times that of the vertex colour.
    float alphaCutoff = 0.0F;
};

// Triangles of one material, in object space. The function that takes the description copies the spans.
struct MeshDescription {
    std::span<const float> positions;             // x, y, z per vertex
    std::span<const float> normals;               // x, y, z per vertex, of any length but 0
    std::span<const std::uint32_t> indices;       // three per triangle; counter-clockwise is front
    std::size_t material = 0;                     // index into SceneDescription::materials
    std::span<const float> textureCoordinates{};  // u, v per vertex; needed if the material has textures
    // Linear r, g, b, a per vertex, 0 to 1, which multiply baseColor and its alpha; or none.
    std::span<const float> colors{};
    // True: setVertices() may change it. It then has exactly one instance, and that has `moves`.
    bool deforms = false;
};

// Vertices of a mesh in GL buffers of the program. Offsets and strides are in bytes, multiples of 4.
struct VertexBuffers {
    unsigned positions = 0, normals = 0;  // names of buffers, or of one; floats as in MeshDescription
    std::size_t positionOffset = 0, positionStride = 12;
    std::size_t normalOffset = 0, normalStride = 12;
};

// A mesh in the world.
struct InstanceDescription {
    std::size_t mesh = 0;  // index into SceneDescription::meshes
    Matrix worldFromObject;
    // True: setTransform(), setVisible() and setEmission() may change it, which costs memory and time. It
    // makes no difference to addInstance().
    bool moves = false;
    bool isVisible = true;  // false needs `moves`
};

// The sun. Other light comes from `lights`, emission and the sky.
struct Sun {
    std::array<double, 3> directionToSun{0, 1, 0};  // direction towards the sun; any length but 0
    std::array<float, 3> color{1, 1, 1};  // multiplies the illuminance; the largest component must be 1
    float illuminance = 3.14159265F;      // on a surface that faces the sun, for example in lux
    float diameterDegrees = 5.0F;         // full opening angle of its disc, 0.1 to 170
};

// A light in the scene besides the sun, as in glTF's KHR_lights_punctual. Radiance includes its direct light,
// and the light that surfaces reflect of it.
struct LightDescription {
    enum class Type { point, spot, directional };
    Type type = Type::point;
    std::array<double, 3> position{0, 0, 0};    // of a point or spot light, in metres
    std::array<double, 3> direction{0, -1, 0};  // of a spot or directional light's rays; any length but 0
    std::array<float, 3> color{1, 1, 1};        // multiplies the intensity; 0 to 1
    // Illuminance of a surface that faces the light, in the unit of Sun::illuminance; for a point or spot
    // light at a distance of a metre, so that it is in candela if the unit is lux.
    float intensity = 1.0F;
    float range = std::numeric_limits<float>::infinity();  // metres; it fades out towards this distance
    // Half angles of a spot's cone: where it begins to fade, and where it is dark, at most 90.
    float innerConeDegrees = 0.0F, outerConeDegrees = 45.0F;
    // Its size, for soft shadows; 0: hard ones, which take less time.
    float radius = 0.0F;           // metres, of a point or spot light
    float diameterDegrees = 0.0F;  // full opening angle of a directional light, at most 170
};

// A sky that depends on direction, as an equirectangular picture. Row 0 is at the top, towards +Y. The
// middle of a row is towards +X, and +Z is a quarter of the width to the right of it. The constructor of
// GlobalIllumination copies the span. A sun of a few pixels should be removed and given as a Sun.
struct SkyPicture {
    int width = 0, height = 0;        // twice as wide as high, at most 8192 wide
    std::span<const float> radiance;  // three values per pixel
};

struct SceneDescription {
    // Shaders are made for the kinds of these materials, those that no mesh uses included. A material that is
    // added or changed later must be of one of these kinds: sides, textures that it has, cutoff, emission,
    // and vertex colours of its meshes; glossy if one is; and with no more emission than the brightest.
    std::vector<MaterialDescription> materials;
    std::vector<MeshDescription> meshes;
    std::vector<InstanceDescription> instances;
    // The most instances that addInstance() may bring the scene to, `instances` included. 0: addMesh() and
    // addInstance() are errors.
    std::size_t maxInstances = 0;
    Sun sun;
    std::vector<LightDescription> lights;
    // The most lights that addLight() may bring the scene to, at most 64. Shadow maps take memory for each of
    // them, at most 8 MB in sum. They have room for 16 point lights, or 96 spot or directional lights;
    // beyond that, the lights that give the nearest surfaces the least light cast no shadows.
    std::size_t maxLights = 0;
    // Radiance of a sky of one colour. It is absolute like the sun's illuminance: beside a sun of 100000 lux,
    // a sky of 0.2 is black.
    std::array<float, 3> skyRadiance{0, 0, 0};
    std::optional<SkyPicture> sky;  // replaces skyRadiance
    // The voxels fill a cube around this box and the initial positions of all instances. The cube stays as it
    // is (voxelBounds()). An instance outside of it gives and blocks no indirect light, and far outside it
    // casts no shadows of the sun, so give the box in which instances will move. Voxels are as large as the
    // cube demands, unless Options::voxelSize limits them.
    std::optional<Box> bounds;
};

// A part of the work of a picture that takes long.
struct Progress {
    std::string part;  // "programs" that were made, or steps of "light"
    int done = 0;
    int total = 0;  // 0: not known
};

// Time of a step of render(). docs/timings.md describes the steps.
struct StepTime {
    std::string step;
    double milliseconds = 0.0;
};

struct Options {
    std::string preset = "mobile";  // "thesis", "mobile" or "quality"; docs/embedding.md has their cost
    int grid = 0;                   // voxels along a side: 64, 128, 256 or 512; 0: the preset's
    // Largest size of voxels around the camera, in metres; replaces `grid`. In a scene too large for one cube
    // of such voxels, nested cubes follow the camera (not with "thesis"). 0: no limit.
    float voxelSize = 0.0F;
    int width = 400, height = 400;  // size of the pictures in pixels
    // The pictures that render() draws. Pictures that are not requested cost nothing.
    bool radiance = true, irradiance = false, ambientVisibility = false, sunVisibility = false,
         specular = false;
    std::string shaderFolder;  // folder to read the shaders from; "": the built-in ones
    // Functions of the program, or none. They are called within functions of the GlobalIllumination and must
    // call none of it, and leave GL's state as it is.
    std::function<void(const std::string& message)> log;  // notes, and each shader program with its time
    std::function<void(const Progress& progress)> progress;
    // Return and keep compiled shader programs, so that the next start need not compile them. A key is 32
    // hexadecimal digits and depends on the library and the driver. Return nothing for a key that was never
    // stored. What was damaged, or is of another driver, is compiled again.
    std::function<std::vector<std::uint8_t>(const std::string& key)> loadProgram;
    std::function<void(const std::string& key, std::span<const std::uint8_t> program)> storeProgram;
};

// The camera of the pictures. Clip space is GL's: depth from -1 (near) to 1 (far), unless it is reversed.
struct View {
    Matrix cameraFromWorld;  // a rotation and a translation
    // Perspective (last row 0 0 -1 0) or orthographic (last row 0 0 0 1); depth grows with distance. Glossy
    // reflections are those seen from the camera's origin, also with an orthographic projection.
    Matrix clipFromCamera;
    // True: clip space has depth from 1 (near) to 0 (far, which may be infinite), as with
    // glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE), and GBufferTextures::depth is 0 if there is no surface.
    bool reversedDepth = false;
};

// The caller's G-buffer: names of 2D textures of the pictures' size, row 0 at the bottom. Their sampler
// parameters do not matter, except that `gloss` must have the filter NEAREST.
struct GBufferTextures {
    unsigned albedo = 0;  // GL_RGBA8: square root of the base colour; alpha: z of encodeNormals() / 255
    unsigned normal = 0;  // GL_RG16UI: xy of encodeNormals(); world space, towards the viewer
    unsigned depth = 0;   // GL_DEPTH_COMPONENT32F or GL_DEPTH_COMPONENT24, by View; 1 if there is no surface
    // These are 0 if the scene has no such materials:
    unsigned emission = 0;  // GL_RGBA16F or GL_R11F_G11F_B10F: radiance / GlobalIllumination::radianceUnit()
    unsigned gloss = 0;     // GL_RG8: metallic, roughness
};

// Names of 2D textures: GL_RGBA16F, linear, row 0 at the bottom, NEAREST, CLAMP_TO_EDGE; 0 if Options does
// not request the picture. They belong to the GlobalIllumination and stay valid until resize(). On surfaces
// alpha is 1. Elsewhere alpha is 0 and rgb is the sky's radiance in units of radianceUnit(), in
// every picture.
struct Pictures {
    // The complete light, in units of radianceUnit().
    unsigned radiance = 0;
    // Irradiance by other surfaces, emitters and the sky, without the direct light of sun and lights, divided
    // by pi * radianceUnit(). With the presets mobile and quality, a surface that neither is glossy nor emits
    // has the radiance, in units of radianceUnit() and without the direct light of SceneDescription::lights,
    //     baseColor * (max(dot(normal, directionToSun), 0) * sunVisibility * sun + irradiance),
    // with `normal` and `directionToSun` at unit length, sunVisibility from the picture of that name, and
    // sun = sun.color * sun.illuminance / (pi * radianceUnit()), which usually is sun.color. With the preset
    // thesis this does not hold.
    unsigned irradiance = 0;
    // These have the same value in r, g and b:
    unsigned ambientVisibility = 0;  // 1 - ambient occlusion; not a part of radiance with mobile and quality
    unsigned sunVisibility = 0;      // visible share of the sun's disc: the soft shadow
    // The part of the radiance, in units of radianceUnit(), that glossy surfaces reflect specularly of other
    // surfaces, emitters and the sky: reflections without the highlights of sun and lights. It is 0 on other
    // surfaces, and with the preset thesis.
    unsigned specular = 0;
};

// The places of the inputs of the look-up in a program: eight texture units and two binding points of uniform
// buffers, from these on, and a binding point of storage buffers.
struct LookUpBindings {
    unsigned firstTextureUnit = 0, firstUniformBuffer = 0, storageBuffer = 0;
};

// The function of the window or EGL library that returns GL entry points. A lambda can adapt its type:
// [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }.
using GetProcAddress = void* (*)(const char* name);

// A scene in GL with its voxels and their light.
//
// Every function, including constructor and destructor, leaves GL's state as it found it, whatever it is,
// except:
// - bindLookUp() changes the bindings that it is for.
// - State that GL has per draw buffer (blending and colour masks) becomes that of draw buffer 0 for all draw
//   buffers.
// - An earlier error that glGetError() would return is dropped.
// No query and no transform feedback may be active during a call. In desktop GL, the polygon mode, logic
// operation and clip distances must have their initial values during a call.
//
// The constructor fills a table of GL entry points that the whole process shares. All contexts that use the
// library at the same time must therefore have the same driver.
class GlobalIllumination {
  public:
    // Uploads the scene. Throws if the description is invalid, the driver lacks a feature, or there is not
    // enough memory. The first render() compiles the shaders and builds the voxels. It takes longest, and may
    // throw for the same reasons.
    GlobalIllumination(GetProcAddress getProcAddress, const SceneDescription& scene,
                       const Options& options = {});
    ~GlobalIllumination();
    GlobalIllumination(GlobalIllumination&&) noexcept;
    GlobalIllumination& operator=(GlobalIllumination&&) noexcept;

    // Moves an instance in the next picture. `instance`: index into SceneDescription::instances, with `moves`
    // set.
    void setTransform(std::size_t instance, const Matrix& worldFromObject);
    // Replaces the vertices of a mesh with `deforms`, whose number stays. They are copied at once, on the
    // GPU. `bounds`: around the positions, in object space.
    void setVertices(std::size_t mesh, const VertexBuffers& vertices, const Box& bounds);
    // Shows or hides such an instance. Objects that come and go are described once, hidden, as many as there
    // may be at a time; hidden ones take memory and no time. If moving instances suddenly fill half as many
    // voxels again, by this or by setTransform(), parts of them are too dark for about one picture; a picture
    // with Light::converged is right at once.
    void setVisible(std::size_t instance, bool isVisible);
    // Scales the emission of such an instance, by 0 (a lamp that is off) to 1.
    void setEmission(std::size_t instance, float scale);
    // Materials, meshes and instances that come and go, within SceneDescription::maxInstances. Each add
    // function returns a number, which stays until it is removed; the scene's own have their indices. Each
    // remove function takes what was added, and is an error while something uses it. Added instances are as
    // those with `moves`: they are voxelized when one of them changes, and what does not move is not. Added
    // meshes do not deform, and their emission is in the voxels: describe small lamps, hidden.
    std::size_t addMaterial(const MaterialDescription& material);
    void removeMaterial(std::size_t material);
    std::size_t addMesh(const MeshDescription& mesh);
    void removeMesh(std::size_t mesh);
    std::size_t addInstance(const InstanceDescription& instance);
    void removeInstance(std::size_t instance);
    // Changes a material of the next pictures. If an instance has it that was described without `moves`, all
    // voxels and their light are made again.
    void setMaterial(std::size_t material, const MaterialDescription& description);
    // Turns the sun in the next picture. `directionToSun`: any length but 0.
    void setSun(const std::array<double, 3>& directionToSun);
    // Changes colour and illuminance of the sun, with the same limits as in Sun.
    void setSunlight(const std::array<float, 3>& color, float illuminance);
    // Changes the sky: its radiance, or its picture if the scene was described with one.
    void setSky(const std::array<float, 3>& radiance);
    void setSky(const SkyPicture& picture);
    // Lights of the next pictures. addLight() returns the light's number, which it keeps until it is removed;
    // the scene's own lights have their indices in SceneDescription::lights. Changing only colour or
    // intensity costs less than moving it, because its shadow maps are kept. The first light with a radius or
    // diameter compiles a shader. An intensity of 0 switches a light off.
    std::size_t addLight(const LightDescription& light);
    void setLight(std::size_t number, const LightDescription& light);
    void removeLight(std::size_t number);
    // Recreates the pictures and the G-buffer in another size. Voxels and their light are kept.
    void resize(int width, int height);

    // After a change, indirect light converges over about 16 frames. `oneStep` takes one step per call, for
    // interactive use; `converged` takes all remaining steps, for a still picture.
    // `keep` takes none, for a second view of the same frame; as long as there is no light, it takes one.
    enum class Light { oneStep, converged, keep };
    // Draws the pictures. `gBuffer` is a G-buffer of the caller's that shows the scene from the same View;
    // without it the library draws its own.
    Pictures render(const View& view, Light light = Light::oneStep);
    Pictures render(const View& view, const GBufferTextures& gBuffer, Light light = Light::oneStep);

    // Returns the steps of light since the last change, and the number of all that follow a change. The light
    // of the last picture has converged if both are equal, which with the preset thesis they always are.
    // docs/embedding.md says how large the error is after a number of steps.
    Progress lightProgress() const;

    // The converged indirect light of the instances without `moves`, for useBakedLight() of a later run,
    // which then shows it in its first picture. It needs a render() with Light::converged, a preset other
    // than thesis, Options::voxelSize of 0, and a scene as it was described: neither lights, sky nor
    // materials were changed.
    std::vector<std::uint8_t> bakeLight() const;
    // Takes that light, before the first render(). Throws if it is damaged, or of another description, preset
    // or grid, and names what differs; the light is then computed as without it. The content of the program's
    // textures is not compared. Light with moving instances goes on from the baked one.
    void useBakedLight(std::span<const std::uint8_t> baked);

    // Measures the steps of the next pictures, or stops to. It waits for the GPU after each step, so frames
    // take longer.
    void measureSteps(bool measures);
    // Times of the last picture, in the order of the steps; empty if it was not measured.
    std::vector<StepTime> stepTimes() const;

    // GLSL ES 3.10 with the function
    //     vec3 irradianceAt(vec3 position, vec3 normal)
    // for what is not in the G-buffer, such as glass, particles and forward passes. `position`: any point in
    // world space, on a surface or in the air. `normal`: unit length. Its result has the meaning and unit of
    // Pictures::irradiance. Outside of the voxels it is that of the sky. For the presets mobile and quality.
    //
    // The text has no #version, and all else that it declares begins with vct_. In a fragment or compute
    // shader (or another one, where the driver has storage buffers in it), insert it after "precision highp
    // float;" and "precision highp int;". It is the same for the whole life of the GlobalIllumination.
    std::string lookUpGlsl(const LookUpBindings& bindings = {}) const;
    // Binds the inputs of lookUpGlsl(), which change the bindings of their texture units (textures and
    // sampler), uniform buffers and storage buffer. Call it after each render(), before draws with the
    // look-up. Options must request radiance, irradiance or specular.
    void bindLookUp(const LookUpBindings& bindings = {}) const;

    // The radiance that is 1 in Pictures: the sun's illuminance / pi, which is the radiance of a white
    // surface that faces the sun, or 1 if the sun is off. It is more if something is so bright that half
    // floats could not store it, and less if the sun is off and all light is weak. It stays as it is if
    // lights, sun or sky change later. Light below a 10,000th of it loses precision.
    double radianceUnit() const;

    // The cube of the voxels in world space (SceneDescription::bounds).
    Box voxelBounds() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

// GLSL ES 3.10 functions for your own G-buffer. Normals have unit length.
//   uvec3 encodeNormals(vec3 normal, vec3 faceNormal): the codes of the interpolated normal and the normal of
//     the triangle's plane; xy for the normal texture, z (0 to 255) for the alpha of the albedo
//   vec3 faceNormal(vec3 position, vec3 towards): the normal of the triangle's plane, from derivatives of an
//     interpolated position, on the side of `towards`
//   vec3 decodeNormal(uvec2 code): the interpolated normal
//   vec3 safeNormalize(vec3 v)
// The text has no #version. In a fragment shader, insert it after "precision highp float;" and "precision
// highp int;".
std::string normalEncodingGlsl();

}  // namespace vct
