// Builds small glTF files in memory, right or wrong ones.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/gltf.h"

namespace vct::test {

using Bytes = std::vector<unsigned char>;
using nlohmann::json;

enum ComponentType {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    int32 = 5124,
    uint32 = 5125,
    float32 = 5126
};

class GltfBuilder {
  public:
    json document = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", json::array()}}}}};
    Bytes binary;

    // Appends bytes (4-aligned) as a buffer view; returns its index.
    int view(const void* bytes, std::size_t size);

    // Appends an accessor with a view of its own; `type` as in "VEC3".
    template <class T>
    int accessor(const std::vector<T>& values, int componentType, const std::string& type,
                 bool normalized = false) {
        const std::size_t width = type == "SCALAR" ? 1
                                  : type == "MAT4" ? 16
                                                   : static_cast<std::size_t>(type.back() - '0');
        return accessorOf(view(values.data(), values.size() * sizeof(T)), values.size() / width,
                          componentType, type, normalized);
    }
    int accessorOf(int bufferView, std::size_t count, int componentType, const std::string& type,
                   bool normalized = false);
    int floats(const std::vector<float>& values, const std::string& type = "VEC3") {
        return accessor(values, float32, type);
    }

    // Appends to the array `key` of the document; returns the index.
    int add(const std::string& key, json element);
    // A mesh of one primitive.
    int mesh(json primitive);
    // A node at the root of the scene.
    int node(json node);
    // A node with one triangle (0,0,0) (1,0,0) (0,1,0); makes a file without geometry loadable.
    int triangle();
    // Adds a channel and a sampler to an animation, which is added if there is none. A value has three
    // numbers, four for a rotation, or one for each morph target for weights.
    void animate(int node, const std::string& path, const std::vector<float>& times,
                 const std::vector<float>& values, const std::string& interpolation = "LINEAR",
                 std::size_t animation = 0);
    // A texture of an embedded image.
    int texture(const Bytes& image, json sampler = nullptr);

    Bytes glb() const;
    Bytes gltfWithDataUri() const;
    // The document with one buffer at `uri`.
    Bytes gltf(const std::string& uri) const;
};

// An indexed triangle with that image as its texture, a camera, a light and an animated rotation: an example
// of nearly everything that a file can hold.
GltfBuilder completeFile(const Bytes& image);

// A picture of size x size pixels.
Bytes encodePng(int size);
Bytes encodeJpeg(int size);
std::string base64(const Bytes& bytes);
Bytes bytesOf(const std::string& text);

// Loads from memory under the name "test.glb"; no other file exists.
Scene load(const Bytes& file, const GltfOptions& options = {});
Scene load(const GltfBuilder& builder, const GltfOptions& options = {});

// The message of the vct::Error that loading ends in, or "" where it succeeds.
std::string loadError(const Bytes& file, const GltfOptions& options = {});
std::string loadError(const GltfBuilder& builder, const GltfOptions& options = {});

// Corner positions in object space, three per triangle; each triangle rotated to begin with its smallest
// corner and the triangles sorted: equal for equal triangles whatever the order.
std::vector<glm::vec3> triangleSoup(const Mesh& mesh);

bool hasWarning(const Scene& scene, const std::string& part);

}  // namespace vct::test
