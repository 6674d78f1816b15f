// A scene as plain data. Knows nothing of GL and nothing of the file it came from.
//
// World space: right-handed, +Y up, metres (glTF 2.0). World positions are double: a scene may lie 10^6 units
// from the origin. Vertices are float, relative to the centre of their mesh.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/animation.h"
#include "scene/bounds.h"
#include "scene/deformation.h"

namespace vct {

struct Vertex {
    glm::vec3 position;    // object space, relative to Mesh::centre
    glm::vec3 normal;      // object space, unit length
    glm::vec2 uv;          // of the base-colour texture, KHR_texture_transform applied
    glm::vec2 emissiveUv;  // of the emissive texture, likewise
};

// What a vertex has besides, where its material reads some of it.
struct VertexExtras {
    glm::vec4 color{1.0F};     // linear RGB and alpha; multiplies the base colour
    glm::vec2 glossUv{0.0F};   // of the gloss texture, KHR_texture_transform applied
    glm::vec2 normalUv{0.0F};  // of the normal map, likewise
};

struct Material {
    enum class AlphaMode { opaque, mask };

    std::string name;
    glm::vec4 baseColor{1.0F};  // linear RGB and alpha; multiplies the texture
    int baseColorTexture = -1;  // index into Scene::textures, or -1
    glm::vec3 emissive{0.0F};   // radiance in W/(sr m^2) or nits, strength included; multiplies the texture
    int emissiveTexture = -1;   // index into Scene::textures, or -1
    float metallic = 1.0F;      // 0 to 1; the defaults are those of glTF
    float roughness = 1.0F;     // 0 to 1
    int glossTexture = -1;   // index into Scene::textures, or -1: green times roughness, blue times metallic
    int normalTexture = -1;  // index into Scene::textures, or -1: a normal map in tangent space
    float normalScale = 1.0F;   // of the normal map's x and y
    bool vertexColors = false;  // VertexExtras::color counts
    bool unlit = false;  // shows its base colour whatever the light, and neither receives nor sends any
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5F;
    bool doubleSided = false;
};

// Triangles of one material. Counter-clockwise is front.
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<VertexExtras> extras;    // as many as vertices, or none where the material reads none of it
    std::vector<std::uint32_t> indices;  // three per triangle, all below vertices.size()
    int material = 0;                    // index into Scene::materials
    glm::dvec3 centre{0.0};              // object space: file position = centre + Vertex::position
    // Where the mesh changes its form: how. Its vertices are then as that leaves them at rest, in world
    // space, and one instance alone shows it. Null elsewhere.
    std::shared_ptr<const Deformation> deformation;
};

// A mesh placed in the world.
struct Instance {
    int mesh = 0;
    glm::dmat4 worldFromObject{
        1.0};              // of the file's object space, so before Mesh::centre is subtracted; at rest
    int node = -1;         // the one that moves it, of Scene::animation; -1: none does
    bool deforms = false;  // Mesh::deformation moves it

    bool moves() const { return node >= 0 || deforms; }
};

// Bytes that do not change, and that several owners share.
class SharedBytes {
  public:
    SharedBytes(std::vector<std::uint8_t> bytes = {})
        : bytes_(std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes))) {}

    const std::uint8_t* data() const { return bytes_->data(); }
    std::size_t size() const { return bytes_->size(); }
    const std::uint8_t& operator[](std::size_t i) const { return (*bytes_)[i]; }
    bool operator==(const SharedBytes& other) const { return *bytes_ == *other.bytes_; }

  private:
    std::shared_ptr<const std::vector<std::uint8_t>> bytes_;
};

// 8-bit RGBA, sRGB-encoded colour (linear alpha), first row at the top (glTF: uv (0,0)).
struct Texture {
    enum class Wrap { repeat, clampToEdge, mirroredRepeat };

    std::string name;
    int width = 0;
    int height = 0;
    SharedBytes rgba;  // by textures of one image, which may repeat it differently
    Wrap wrapS = Wrap::repeat;
    Wrap wrapT = Wrap::repeat;
    bool linearFilter = true;  // magnification; minification is always trilinear
};

// glTF camera convention: looks along its -Z, +Y up.
struct Camera {
    std::string name;
    glm::dmat4 worldFromCamera{1.0};  // rigid: rotation and translation only
    double verticalFovRad = 0.8;
    // Width over height of the picture that it is made for; camera.h's fitted() makes it fit another.
    std::optional<double> aspectRatio;
    // World units: what is no nearer is seen, however large the scene. (Of a scene of a kilometre around the
    // camera, what is nearer than a metre would be cut off otherwise.)
    double nearest = std::numeric_limits<double>::infinity();
    int node = -1;         // as Instance::node
    double setBack = 0.0;  // world units, that the eye lies behind the node
    // Where it is set, clipFromWorld() gives this and fits nothing to the scene. Depth is 1 at its far plane.
    std::optional<glm::dmat4> clipFromWorld;
};

// The sun: the scene's first directional light.
struct DirectionalLight {
    glm::dvec3 directionToLight{0.0, 1.0, 0.0};  // world, unit length
    glm::vec3 color{1.0F};                       // linear RGB, largest component 1 (0 when the light is off)
    float intensity = 3.14159265F;               // E in lux: irradiance of a surface that faces the light
    int node = -1;                               // as Instance::node
};

// A light besides the sun, of glTF's extension KHR_lights_punctual. It shines along its -Z.
struct PunctualLight {
    enum class Type { directional, point, spot };

    std::string name;
    Type type = Type::point;
    glm::dmat4 worldFromLight{1.0};                          // rigid: rotation and translation only
    glm::vec3 color{1.0F};                                   // linear RGB, largest component 1
    float intensity = 1.0F;                                  // in candela; of a directional one in lux
    double range = std::numeric_limits<double>::infinity();  // metres, from where on it gives no light
    // Of a spot, between its axis and where it begins to fade, and where it is dark.
    double innerConeRad = 0.0;
    double outerConeRad = 0.7853981633974483;
    int node = -1;  // as Instance::node
};

// Everything is at rest, as the nodes of the file put it; a Pose of the animation says where what moves is at
// a time.
struct Scene {
    std::string path;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Camera> cameras;
    std::vector<DirectionalLight> lights;       // at most one: the sun
    std::vector<PunctualLight> punctualLights;  // all others
    Animation animation;
    // Of all instances' vertices that triangles use: at rest, and in the animation's poses as far as
    // computeBounds() says.
    Bounds boundsWorld;
    std::vector<std::string> warnings;  // what the file asks for that is not honoured

    std::size_t triangleCount() const {
        std::size_t count = 0;
        for (const Instance& instance : instances)
            count += meshes[instance.mesh].indices.size() / 3;
        return count;
    }
};

}  // namespace vct
