// Loads meshes, materials and textures of a glTF file. Materials and textures are loaded only if they are
// used, and once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "scene/gltf_file.h"

namespace vct {

// Source of a texture's coordinates: a TEXCOORD set and KHR_texture_transform.
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

// Loads textures. Each image is decoded once; textures with the same image and sampler become one texture.
class TextureLoader {
  public:
    TextureLoader(GltfFile& file, Scene& scene) : file_(file), scene_(scene) {}

    // Returns the index into Scene::textures of the texture `index` of the file, which it loads if necessary.
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
    std::map<int, int> textures_;           // from index in the file to index in the scene
    std::map<std::string, Pixels> pixels_;  // key: identityOf() the image's URI, or its buffer view
    // Index in the scene by image and sampler.
    std::map<std::tuple<const void*, Texture::Wrap, Texture::Wrap, bool>, int> known_;
};

class MaterialLoader {
  public:
    MaterialLoader(GltfFile& file, Scene& scene) : file_(file), scene_(scene), textures_(file, scene) {}

    // Returns the material `index` of the file, which it loads if necessary; -1 is glTF's default material.
    // `vertexColors`: the mesh has vertex colours.
    const MaterialUse& get(int index, bool vertexColors);

  private:
    MaterialUse load(const tinygltf::Material& source);
    bool isHole(const tinygltf::Material& source);
    void loadEmissionAndNormals(const tinygltf::Material& source, Material& material, MaterialUse& use);
    // Converts KHR_materials_pbrSpecularGlossiness to the most similar metallic-roughness material.
    void loadSpecularGlossiness(const tinygltf::Value& extension, Material& material, MaterialUse& use);
    // Returns the index into Scene::textures, or -1 if `info` refers to no texture.
    template <class Info>
    int texture(const Info& info, UvSource& uv);

    GltfFile& file_;
    Scene& scene_;
    std::map<std::pair<int, bool>, MaterialUse> materials_;  // key: index in the file, vertexColors
    TextureLoader textures_;
};

// Loads one primitive of the mesh `meshIndex`, which must exist. Returns nothing if the primitive has no
// triangles (points and lines are left out with a warning).
std::optional<Mesh> loadPrimitive(GltfFile& file, const tinygltf::Primitive& primitive,
                                  MaterialLoader& materials, std::size_t meshIndex);

}  // namespace vct
