// A scene as plain data. It knows nothing of GL and nothing of its file's format.
//
// World space is right-handed with +Y up, in metres (glTF 2.0). World positions are double, because a scene
// may lie 10^6 units from the origin. Vertices are float, relative to the centre of their mesh.
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
    glm::vec3 position;  // object space, relative to Mesh::centre
    glm::vec3 normal;    // object space, unit length
    // Texture coordinates, after KHR_texture_transform.
    glm::vec2 uv;          // base-colour texture
    glm::vec2 emissiveUv;  // emissive texture
};

// Further attributes of a vertex, for materials that use at least one of them.
struct VertexExtras {
    glm::vec4 color{1.0F};  // linear RGB and alpha; multiplies the base colour
    // Texture coordinates, after KHR_texture_transform.
    glm::vec2 glossUv{0.0F};   // gloss texture
    glm::vec2 normalUv{0.0F};  // normal map
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
    int glossTexture = -1;      // index or -1; green multiplies roughness, blue multiplies metallic
    int normalTexture = -1;     // index or -1; a normal map in tangent space
    float normalScale = 1.0F;   // multiplies x and y of the normal map
    bool vertexColors = false;  // VertexExtras::color is used
    bool unlit = false;         // shows its base colour in any light, and neither receives nor sends light
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5F;
    bool doubleSided = false;

    // The material reflects specularly. Others are Lambertian.
    bool isGlossy() const { return roughness < 1.0F || metallic > 0.0F || glossTexture >= 0; }
};

// Triangles of one material. A triangle is counter-clockwise seen from its front.
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<VertexExtras> extras;    // one per vertex, or none if the material uses none of them
    std::vector<std::uint32_t> indices;  // three per triangle, all below vertices.size()
    int material = 0;                    // index into Scene::materials
    glm::dvec3 centre{0.0};              // object space: file position = centre + Vertex::position
    // The deformation of a mesh that changes its form; null for other meshes. The vertices of a deformed mesh
    // are those of the rest pose, in world space, and it has only one instance.
    std::shared_ptr<const Deformation> deformation;
};

// The corners of the mesh's bounds, object space.
std::vector<glm::dvec3> cornersOf(const Mesh& mesh);

// A mesh placed in the world.
struct Instance {
    int mesh = 0;
    // At rest. It transforms positions of the file's object space: Mesh::centre + Vertex::position.
    glm::dmat4 worldFromObject{1.0};
    int node = -1;         // node of Scene::animation that moves it; -1: none
    bool deforms = false;  // Mesh::deformation moves it

    bool moves() const { return node >= 0 || deforms; }
};

// Immutable bytes with shared ownership.
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

// An 8-bit RGBA texture. Colours are sRGB-encoded, alpha is linear. The first row is at the top (uv (0, 0) of
// glTF). A texture of the embedding program has its GL name in place of all else.
struct Texture {
    enum class Wrap { repeat, clampToEdge, mirroredRepeat };

    std::string name;
    int width = 0;
    int height = 0;
    SharedBytes rgba;  // shared by textures of the same image with different samplers
    Wrap wrapS = Wrap::repeat;
    Wrap wrapT = Wrap::repeat;
    bool linearFilter = true;  // for magnification; minification is always trilinear
    unsigned external = 0;     // GL name, or 0
};

// A camera by glTF's convention: it looks along its -Z, and +Y is up.
struct Camera {
    std::string name;
    glm::dmat4 worldFromCamera{1.0};  // rigid: rotation and translation only
    double verticalFovRad = 0.8;
    // Width over height of the picture that the camera is made for. fitted() in camera.h fits it to another.
    std::optional<double> aspectRatio;
    // Objects at this distance or farther are visible, in world units. (Without it the near plane would
    // follow from the size of the scene, and in a scene of a kilometre it could cut off objects within a
    // metre.)
    double nearest = std::numeric_limits<double>::infinity();
    int node = -1;         // see Instance::node
    double setBack = 0.0;  // distance of the eye behind the node, world units
    // If it is set, clipFromWorld() in camera.h returns this matrix. Its depth is 1 at the far plane.
    std::optional<glm::dmat4> clipFromWorld;
    // Depth of a G-buffer of the caller's is clipFromWorld's, from 1 at the near plane to 0 at the far plane.
    bool reversedDepth = false;
};

// The sun: the scene's first directional light.
struct DirectionalLight {
    glm::dvec3 directionToLight{0.0, 1.0, 0.0};  // world space, unit length
    glm::vec3 color{1.0F};                       // linear RGB, largest component 1 (0 if the light is off)
    float intensity = 3.14159265F;               // illuminance in lux of a surface that faces the light
    int node = -1;                               // see Instance::node
};

// A light besides the sun, of glTF's extension KHR_lights_punctual. Its axis is its -Z.
struct PunctualLight {
    enum class Type { directional, point, spot };

    std::string name;
    Type type = Type::point;
    glm::dmat4 worldFromLight{1.0};                          // rigid: rotation and translation only
    glm::vec3 color{1.0F};                                   // linear RGB, largest component 1
    float intensity = 1.0F;                                  // candela, or lux of a directional light
    double range = std::numeric_limits<double>::infinity();  // metres; it gives no light beyond
    // Angles from a spot light's axis: where it begins to fade, and where it is dark.
    double innerConeRad = 0.0;
    double outerConeRad = 0.7853981633974483;
    // Its size, for soft shadows: the radius in metres, or of a directional light the tangent of half its
    // opening angle. Without it the settings decide.
    std::optional<double> size;
    int node = -1;  // see Instance::node
};

// A scene in its rest pose, as the nodes of the file place it. A Pose of the animation moves it.
struct Scene {
    std::string path;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Camera> cameras;
    std::vector<DirectionalLight> lights;       // at most one: the sun
    std::vector<PunctualLight> punctualLights;  // all other lights
    std::size_t punctualLightRoom = 0;          // number of punctual lights that may be added later
    std::size_t instanceRoom = 0;               // number of instances that may be added later
    bool materialsChange = false;               // instances may get any of the materials later
    Animation animation;
    // Bounds of the vertices that triangles of instances use, at rest and, within the limit of
    // computeBounds(), in the poses of the animation.
    Bounds boundsWorld;
    std::vector<std::string> warnings;  // features of the file that are not supported

    bool mayHavePunctualLights() const { return !punctualLights.empty() || punctualLightRoom > 0; }
    std::size_t triangleCount() const {
        std::size_t count = 0;
        for (const Instance& instance : instances)
            count += meshes[instance.mesh].indices.size() / 3;
        return count;
    }
};

}  // namespace vct
