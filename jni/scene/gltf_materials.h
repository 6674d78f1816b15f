// Meshes, materials and textures of a glTF file. Only those that are used are made, and each once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "scene/gltf_file.h"

namespace vct {

// Where a texture's coordinates come from: a TEXCOORD set and KHR_texture_transform.
struct UvSource {
    int texCoord = 0;
    bool hasTexture = false;
    glm::dmat2 rotationScale{1.0};
    glm::dvec2 offset{0.0};

    glm::vec2 operator()(const glm::vec2& uv) const {
        return glm::vec2(rotationScale * glm::dvec2(uv) + offset);
    }
    bool isSameAs(const UvSource& other) const {
        return texCoord == other.texCoord && rotationScale == other.rotationScale && offset == other.offset;
    }
};

struct MaterialUse {
    int material = 0;  // index into Scene::materials
    UvSource baseColor;
    UvSource emissive;
    UvSource gloss;
    UvSource normal;
};

// Textures by index in the file. An image is decoded once, whoever uses it; textures that are the same in
// image and sampler are one.
class TextureLoader {
  public:
    TextureLoader(GltfFile& file, Scene& scene) : file_(file), scene_(scene) {}

    // Index into Scene::textures. Decodes 8-bit RGBA from PNG or JPEG.
    int get(int index);

  private:
    struct Pixels {
        int width = 0, height = 0;
        SharedBytes rgba;
    };
    Texture load(int index);
    const Pixels& pixels(const tinygltf::Image& image, const std::string& what);

    GltfFile& file_;
    Scene& scene_;
    std::map<int, int> textures_;           // index in the file to that in the scene
    std::map<std::string, Pixels> pixels_;  // by where they come from
    std::map<std::tuple<const void*, Texture::Wrap, Texture::Wrap, bool>, int>
        known_;  // by image and sampler
};

class MaterialLoader {
  public:
    MaterialLoader(GltfFile& file, Scene& scene) : file_(file), scene_(scene), textures_(file, scene) {}

    // The material `index` of the file; -1 is glTF's default material. `vertexColors`: of a mesh that has
    // some.
    const MaterialUse& get(int index, bool vertexColors);

  private:
    MaterialUse load(const tinygltf::Material& source);
    void loadEmissionAndNormals(const tinygltf::Material& source, Material& material, MaterialUse& use);
    // KHR_materials_pbrSpecularGlossiness as the metallic-roughness material that comes nearest.
    void loadSpecularGlossiness(const tinygltf::Value& extension, Material& material, MaterialUse& use);
    // Index into Scene::textures, or -1 where `info` names none.
    template <class Info>
    int texture(const Info& info, UvSource& uv);

    GltfFile& file_;
    Scene& scene_;
    std::map<std::pair<int, bool>, MaterialUse> materials_;  // by index in the file and vertexColors
    TextureLoader textures_;
};

// One primitive as a Mesh. `meshIndex`: of the mesh that the primitive is of, which must exist. Nothing where
// the primitive has no triangles (points and lines are left out with a warning).
std::optional<Mesh> loadPrimitive(GltfFile& file, const tinygltf::Primitive& primitive,
                                  MaterialLoader& materials, std::size_t meshIndex);

}  // namespace vct
