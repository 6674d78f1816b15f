#include "support/gltf_builder.h"

#include <stb_image_write.h>

#include <algorithm>
#include <array>

#include "support/errors.h"

namespace vct::test {
namespace {

void append32(Bytes& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<unsigned char>((value >> shift) & 0xFFU));
}

void pad(Bytes& bytes, unsigned char filler) {
    while (bytes.size() % 4 != 0)
        bytes.push_back(filler);
}

Bytes picture(int size) {
    Bytes rgba;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const int pixel[] = {x * 255 / size, y * 255 / size, (x * y) % 251, 255};
            for (const int channel : pixel)
                rgba.push_back(static_cast<unsigned char>(channel));
        }
    }
    return rgba;
}

void collect(void* context, void* data, int size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    static_cast<Bytes*>(context)->insert(static_cast<Bytes*>(context)->end(), bytes, bytes + size);
}

}  // namespace

int GltfBuilder::view(const void* bytes, std::size_t size) {
    pad(binary, 0);
    const std::size_t offset = binary.size();
    const auto* begin = static_cast<const unsigned char*>(bytes);
    binary.insert(binary.end(), begin, begin + size);
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
}

int GltfBuilder::accessorOf(int bufferView, std::size_t count, int componentType, const std::string& type,
                            bool normalized) {
    return add("accessors", {{"bufferView", bufferView},
                             {"count", count},
                             {"componentType", componentType},
                             {"type", type},
                             {"normalized", normalized}});
}

int GltfBuilder::add(const std::string& key, json element) {
    document[key].push_back(std::move(element));
    return static_cast<int>(document[key].size()) - 1;
}

int GltfBuilder::mesh(json primitive) {
    return add("meshes", {{"primitives", {std::move(primitive)}}});
}

int GltfBuilder::node(json node) {
    const int index = add("nodes", std::move(node));
    document["scenes"][0]["nodes"].push_back(index);
    return index;
}

int GltfBuilder::triangle() {
    const int positions = floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    return node({{"mesh", mesh({{"attributes", {{"POSITION", positions}}}})}});
}

void GltfBuilder::animate(int node, const std::string& path, const std::vector<float>& times,
                          const std::vector<float>& values, const std::string& interpolation,
                          std::size_t animation) {
    const int input = floats(times, "SCALAR");
    const int output = floats(values, path == "rotation" ? "VEC4" : path == "weights" ? "SCALAR" : "VEC3");
    json& all = document["animations"];
    while (all.size() <= animation)
        all.push_back({{"channels", json::array()}, {"samplers", json::array()}});
    json& target = all[animation];
    target["channels"].push_back(
        {{"sampler", target["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    target["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
}

int GltfBuilder::texture(const Bytes& image, json sampler) {
    json texture = {{"source", add("images", {{"bufferView", view(image.data(), image.size())},
                                              {"mimeType", "image/png"}})}};
    if (!sampler.is_null()) texture["sampler"] = add("samplers", std::move(sampler));
    return add("textures", std::move(texture));
}

Bytes GltfBuilder::glb() const {
    json complete = document;
    if (!complete.contains("buffers")) complete["buffers"] = {{{"byteLength", binary.size()}}};
    Bytes text = bytesOf(complete.dump());
    Bytes data = binary;
    pad(text, ' ');
    pad(data, 0);

    Bytes file = bytesOf("glTF");
    append32(file, 2);
    append32(file, 12 + 8 + text.size() + 8 + data.size());
    append32(file, text.size());
    append32(file, 0x4E4F534A);
    file.insert(file.end(), text.begin(), text.end());
    append32(file, data.size());
    append32(file, 0x004E4942);
    file.insert(file.end(), data.begin(), data.end());
    return file;
}

Bytes GltfBuilder::gltf(const std::string& uri) const {
    json complete = document;
    complete["buffers"] = {{{"byteLength", binary.size()}, {"uri", uri}}};
    return bytesOf(complete.dump(1));
}

Bytes GltfBuilder::gltfWithDataUri() const {
    return gltf("data:application/octet-stream;base64," + base64(binary));
}

GltfBuilder completeFile(const Bytes& image) {
    GltfBuilder b;
    const int positions = b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});  // accessor, view 0
    const int normals = b.floats({0, 0, 1, 0, 0, 1, 0, 0, 1});    // 1
    const int uv = b.floats({0, 0, 1, 0, 0, 1}, "VEC2");          // 2
    const int indices = b.accessor(std::vector<std::uint16_t>{0, 1, 2, 3}, uint16, "SCALAR");  // 3
    b.document["accessors"][3]["count"] = 3;
    b.document["accessors"][0]["sparse"] = {{"count", 1},  // writes what is there already
                                            {"indices", {{"bufferView", 3}, {"componentType", uint16}}},
                                            {"values", {{"bufferView", 0}}}};
    b.texture(image);
    b.document["textures"][0]["sampler"] = b.add("samplers", {{"wrapS", 10497}});
    b.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    b.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}});
    b.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}};
    b.node(
        {{"mesh", b.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}}},
                          {"indices", indices},
                          {"material", 0}})}});
    b.node({{"camera", 0}});
    b.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    b.animate(0, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, 1, 0});  // accessors 4 and 5
    b.document["animations"][0]["name"] = "spin";
    return b;
}

Bytes encodePng(int size) {
    Bytes file;
    stbi_write_png_to_func(collect, &file, size, size, 4, picture(size).data(), 0);
    return file;
}

Bytes encodeJpeg(int size) {
    Bytes file;
    stbi_write_jpg_to_func(collect, &file, size, size, 4, picture(size).data(), 80);
    return file;
}

std::string base64(const Bytes& bytes) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
        for (int k = 0; k < 4; ++k) {
            const bool padding = i + static_cast<std::size_t>(k) > bytes.size();
            text += padding ? '=' : digits[(bits >> (18 - 6 * k)) & 63U];
        }
    }
    return text;
}

Bytes bytesOf(const std::string& text) {
    return Bytes(text.begin(), text.end());
}

Scene load(const Bytes& file, const GltfOptions& options) {
    const auto read = [&](const std::string& path) {
        if (path != "test.glb") throw Error("cannot read " + path + ": there is no such file");
        return file;
    };
    return loadGltf("test.glb", read, options);
}

Scene load(const GltfBuilder& builder, const GltfOptions& options) {
    return load(builder.glb(), options);
}

std::string loadError(const Bytes& file, const GltfOptions& options) {
    return errorOf([&] { load(file, options); });
}

std::string loadError(const GltfBuilder& builder, const GltfOptions& options) {
    return loadError(builder.glb(), options);
}

std::vector<glm::vec3> triangleSoup(const Mesh& mesh) {
    using Corner = std::array<float, 3>;
    std::vector<std::array<Corner, 3>> triangles;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<Corner, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 p = mesh.centre + glm::dvec3(mesh.vertices.at(mesh.indices[i + k]).position);
            corners[k] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    std::vector<glm::vec3> soup;
    for (const auto& triangle : triangles) {
        for (const Corner& corner : triangle)
            soup.emplace_back(corner[0], corner[1], corner[2]);
    }
    return soup;
}

bool hasWarning(const Scene& scene, const std::string& part) {
    return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                       [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

}  // namespace vct::test
