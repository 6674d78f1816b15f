// Global illumination by voxel cone tracing, for a program that has an OpenGL ES 3.1 context (with the
// Android Extension Pack's image atomics; desktop OpenGL 4.5 serves too). docs/embedding.md introduces it.
//
// World space is right-handed with +Y up; its unit is the metre. Colours are linear RGB (Rec. 709 primaries),
// radiance is absolute, in the unit per steradian that the sun's illuminance is in. Matrices are in
// column-major order and multiply column vectors from the left, as in GL and glm.
//
// Every function but the constructors of plain data needs the GL context to be current with which the
// GlobalIllumination was made, and throws vct::Error, whose message names the cause and the remedy. Nothing
// here is safe to call from two threads at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "vct/error.h"

namespace vct {

struct Matrix {
    std::array<double, 16> columns{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    // Of sixteen floats or doubles: Matrix::of(glm::value_ptr(m)), for example.
    template <class Number>
    static Matrix of(const Number* sixteen) {
        Matrix matrix;
        for (std::size_t i = 0; i < 16; ++i)
            matrix.columns[i] = static_cast<double>(sixteen[i]);
        return matrix;
    }
};

struct MaterialDescription {
    std::array<float, 3> baseColor{1, 1, 1};  // 0 to 1
    std::array<float, 3> emission{0, 0, 0};   // radiance, from 0 on
    // Below a roughness of 1 the surface is glossy, with the presets mobile and quality: metallic-roughness
    // as in glTF 2.0. Both are between 0 and 1.
    float metallic = 0.0F;
    float roughness = 1.0F;
    // The triangles of others are seen from their front alone and vanish from behind, but cast shadows either
    // way.
    bool doubleSided = false;
};

// Triangles of one material, in object space. The spans are read by the constructor of GlobalIllumination
// alone.
struct MeshDescription {
    std::span<const float> positions;        // x, y, z of each vertex
    std::span<const float> normals;          // x, y, z of each vertex, of any length but 0
    std::span<const std::uint32_t> indices;  // three of each triangle; counter-clockwise is front
    std::size_t material = 0;                // index into SceneDescription::materials
};

// A mesh in the world.
struct InstanceDescription {
    std::size_t mesh = 0;  // index into SceneDescription::meshes
    Matrix worldFromObject;
    bool moves = false;  // Whether setTransform() may move it, which costs memory and time.
};

// The only light besides emission and the sky.
struct Sun {
    std::array<double, 3> directionToSun{0, 1, 0};  // of any length but 0
    std::array<float, 3> color{1, 1, 1};            // multiplies the illuminance; the largest must be 1
    float illuminance = 3.14159265F;                // of a surface that faces it (lux, for example)
    float diameterDegrees = 5.0F;                   // full opening angle, 0.1 to 170: how soft shadows are
};

struct Box {
    std::array<double, 3> min, max;
};

// A sky that is not the same in all directions: equirectangular, row 0 at the top, which is towards +Y. The
// middle of a row is towards +X, and +Z a quarter of the width to the right of it. Read by the constructor of
// GlobalIllumination alone. A sun of a few pixels is better a Sun.
struct SkyPicture {
    int width = 0, height = 0;        // twice as wide as high, at most 8192 wide
    std::span<const float> radiance;  // three of each pixel
};

struct SceneDescription {
    std::vector<MaterialDescription> materials;
    std::vector<MeshDescription> meshes;
    std::vector<InstanceDescription> instances;
    Sun sun;
    // Of directions that leave the scene: absolute as the sun's illuminance is, so beside 100000 lux a sky of
    // 0.2 is black.
    std::array<float, 3> skyRadiance{0, 0, 0};
    std::optional<SkyPicture> sky;  // in place of that
    // The voxels fill a cube around all instances where they are at first, and around this box. What moves
    // out of the cube neither lights nor shadows anything.
    std::optional<Box> bounds;
};

struct Options {
    std::string preset = "mobile";  // "thesis", "mobile" or "quality": docs/embedding.md has their cost
    int grid = 0;                   // voxels along a side: 64, 128, 256 or 512; 0: the preset's
    int width = 400, height = 400;  // of the pictures, in pixels
    // Which pictures render() makes; those that are not asked for cost nothing.
    bool radiance = true, irradiance = false, ambientVisibility = false, sunVisibility = false;
    std::string shaderFolder;  // A folder to read the shaders from; "": those that were built in.
};

// Where the pictures are seen from. Clip space is GL's: depth from -1 (near) to 1 (far) in it.
struct View {
    Matrix cameraFromWorld;  // a rotation and a translation
    // The projection, perspective (its last row is 0 0 -1 0) or orthographic (0 0 0 1), by which depth grows
    // with distance. By either, glossy surfaces show what they reflect towards the camera's origin.
    Matrix clipFromCamera;
};

// A G-buffer of the caller's: names of 2D textures of the pictures' size, row 0 at the bottom. Their sampler
// parameters do not matter, but those of `gloss`, which must have the filter NEAREST.
struct GBufferTextures {
    unsigned albedo = 0;  // GL_RGBA8: the square root of the base colour; a is not read
    unsigned normal =
        0;               // GL_RG16UI: encodeNormal() of normalEncodingGlsl(), world space, towards the viewer
    unsigned depth = 0;  // GL_DEPTH_COMPONENT32F or GL_DEPTH_COMPONENT24, of View; 1 where there is nothing
    // 0 where the scene has no such materials:
    unsigned emission = 0;  // GL_RGBA16F: radiance / GlobalIllumination::radianceUnit()
    unsigned gloss = 0;     // GL_RG8: metallic, roughness
};

// Names of 2D textures, GL_RGBA16F, row 0 at the bottom, NEAREST and CLAMP_TO_EDGE; 0 where Options does not
// ask for it. They are linear. They belong to the GlobalIllumination, and are the same ones until resize(). a
// is 1 on surfaces; where there are none (depth is 1) it is 0, and rgb is the sky's radiance, in units of
// radianceUnit(), in each of the pictures.
struct Pictures {
    // What the camera sees, in units of radianceUnit().
    unsigned radiance = 0;
    // What surfaces receive of other surfaces, emitters and the sky, but not of the sun: 1 is the sun's
    // illuminance. With the presets mobile and quality, but not with thesis, a surface that is not glossy and
    // does not emit shows the radiance, in units of radianceUnit():
    // baseColor * (max(dot(normal, directionToSun), 0) * sunVisibility * sun.color + irradiance),
    // where normal and directionToSun have length 1 and sunVisibility is that picture's r.
    unsigned irradiance = 0;
    // These have the same number in r, g and b:
    unsigned ambientVisibility = 0;  // 1 - ambient occlusion; with mobile and quality no part of radiance
    unsigned sunVisibility = 0;      // the soft shadow: the share of the sun's disc that is seen
};

// Of the window or EGL library that made the context. Most return another type, which takes a lambda:
// [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }.
using GetProcAddress = void* (*)(const char* name);

// A scene in GL with its voxels and their light.
//
// GL state. Each function, the constructor and the destructor included, leaves these as they were: the
// framebuffers that are bound for drawing and for reading, viewport, scissor box, depth range, colour and
// depth masks, depth function, culled face and front face, the program, the vertex array, the active texture
// unit, and whether these are enabled: GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST,
// GL_POLYGON_OFFSET_FILL, GL_RASTERIZER_DISCARD. (Of what GL has per draw buffer, that of buffer 0 becomes
// all of theirs.) It uses and leaves undefined: textures of units 0 to 15 and 31, whose samplers are 0
// afterwards; images of units 0 to 3; uniform buffers 0 to 5 and shader storage buffers 0 to 4; and what is
// bound to GL_ARRAY_BUFFER, GL_UNIFORM_BUFFER, GL_SHADER_STORAGE_BUFFER, GL_COPY_READ_BUFFER,
// GL_COPY_WRITE_BUFFER, GL_DRAW_INDIRECT_BUFFER and GL_DISPATCH_INDIRECT_BUFFER. Everything else is neither
// read nor changed. While a function runs, no query and no transform feedback may be active. An error that
// glGetError() has kept from before is dropped.
//
// The only state of the process is the table of GL entry points, which the constructor fills: all contexts
// that use the library at the same time must be of one driver.
class GlobalIllumination {
  public:
    // Uploads the scene. Throws where the description is wrong, the driver lacks something, or memory does
    // not suffice. The first render() compiles the shaders and makes the voxels, so it takes longest, and may
    // throw for the same causes.
    GlobalIllumination(GetProcAddress getProcAddress, const SceneDescription& scene,
                       const Options& options = {});
    ~GlobalIllumination();
    GlobalIllumination(GlobalIllumination&&) noexcept;
    GlobalIllumination& operator=(GlobalIllumination&&) noexcept;

    // These are seen in the next picture. The voxels near what moved, or the light of all of them, are made
    // anew then.
    // `instance`: an index into SceneDescription::instances, of one that was declared to move.
    void setTransform(std::size_t instance, const Matrix& worldFromObject);
    // Of any length but 0. Colour, illuminance and diameter stay.
    void setSun(const std::array<double, 3>& directionToSun);
    // Makes the pictures and the G-buffer anew, and nothing else.
    void resize(int width, int height);

    // How far a call brings the light: after a change, what surfaces receive approaches its final value over
    // some 16 frames.
    enum class Light { oneStep, converged };
    // Draws the pictures. With `gBuffer`, from the caller's G-buffer, which must show the scene from the same
    // View; else from a G-buffer of the library's own.
    Pictures render(const View& view, Light light = Light::oneStep);
    Pictures render(const View& view, const GBufferTextures& gBuffer, Light light = Light::oneStep);

    // The radiance that a value of 1 in Pictures::radiance stands for: the sun's illuminance / pi, which is
    // what a white surface that faces the sun sends back; 1 where the sun is off.
    double radianceUnit() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

// GLSL ES 3.10 for the shaders of a G-buffer of your own: uvec2 encodeNormal(vec3 unitLength), vec3
// decodeNormal(uvec2 code) and vec3 safeNormalize(vec3 v). It has no #version; in a fragment shader it comes
// after "precision highp float;" and "precision highp int;".
std::string normalEncodingGlsl();

}  // namespace vct
