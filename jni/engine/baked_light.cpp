#include "engine/baked_light.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "core/hash.h"
#include "core/list_text.h"
#include "engine/environment.h"

namespace vct {

namespace {

class Key {
  public:
    void add(const void* data, std::size_t size) { hash_ = fnv1a(data, size, hash_); }
    void add(std::uint64_t number) { add(&number, sizeof number); }
    // Compilers may fuse a product and a sum, which changes the last bits. The thresholds between two codes
    // are at no number that people write.
    void add(double number) {
        constexpr double codes = 8192.37, offset = 0.31, smallest = 1e-9;
        int exponent = 0;
        const double mantissa = std::frexp(std::abs(number) < smallest ? 0.0 : number, &exponent);
        add(static_cast<std::uint64_t>(std::llround(mantissa * codes + offset)));
        add(static_cast<std::uint64_t>(exponent));
    }
    template <int n, class Number>
    void add(const glm::vec<n, Number>& v) {
        for (int i = 0; i < n; ++i)
            add(static_cast<double>(v[i]));
    }
    void add(const glm::dmat4& m) {
        for (int i = 0; i < 4; ++i)
            add(m[i]);
    }
    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = fnvBasis;
};

std::uint64_t geometryKey(const Scene& scene) {
    Key key;
    for (const Mesh& mesh : scene.meshes) {
        key.add(std::uint64_t{mesh.vertices.size()});
        key.add(mesh.indices.data(), mesh.indices.size() * sizeof mesh.indices[0]);
        key.add(mesh.centre);
        for (const Vertex& vertex : mesh.vertices)
            if (!mesh.deformation) key.add(&vertex.position, sizeof vertex.position);
    }
    for (const Instance& instance : scene.instances) {
        key.add(static_cast<std::uint64_t>(instance.mesh));
        key.add(std::uint64_t{instance.moves()});
        if (!instance.moves()) key.add(instance.worldFromObject);
    }
    return key.value();
}

// Textures count by some of their pixels, because hashing all of them would take longer than the light.
std::uint64_t materialsKey(const Scene& scene) {
    constexpr std::size_t samples = 4096;
    Key key;
    for (const Texture& texture : scene.textures) {
        key.add(glm::dvec2(texture.width, texture.height));
        key.add(static_cast<std::uint64_t>(texture.wrapS) << 8U | static_cast<std::uint64_t>(texture.wrapT));
        const std::size_t step = texture.rgba.size() / samples | 1U;
        for (std::size_t i = 0; i < texture.rgba.size(); i += step)
            key.add(&texture.rgba[i], 1);
    }
    for (const Material& material : scene.materials) {
        key.add(material.baseColor);
        key.add(material.emissive);
        key.add(glm::dvec3(material.metallic, material.roughness, material.alphaCutoff));
        for (const int texture : {material.baseColorTexture, material.emissiveTexture, material.glossTexture})
            key.add(static_cast<std::uint64_t>(texture));
        for (const bool flag : {material.vertexColors, material.unlit, material.doubleSided,
                                material.alphaMode == Material::AlphaMode::mask})
            key.add(std::uint64_t{flag});
    }
    for (const Mesh& mesh : scene.meshes)
        key.add(static_cast<std::uint64_t>(mesh.material));
    return key.value();
}

std::uint64_t lightsKey(const Scene& scene, const DirectionalLight& sun) {
    Key key;
    key.add(sun.directionToLight);
    key.add(sun.color);
    key.add(double{sun.intensity});
    for (const PunctualLight& light : scene.punctualLights) {
        key.add(static_cast<std::uint64_t>(light.type));
        key.add(light.worldFromLight);
        key.add(light.color);
        key.add(double{light.intensity});
        key.add(std::isfinite(light.range) ? light.range : 0.0);
        key.add(glm::dvec2(light.innerConeRad, light.outerConeRad));
    }
    return key.value();
}

std::uint64_t skyKey(const Settings& settings) {
    Key key;
    if (!settings.environment) key.add(settings.skyRadiance);
    if (settings.environment)
        for (const glm::vec3& texel : settings.environment->texels(settings.environment->levels() - 1))
            key.add(texel);
    return key.value();
}

std::uint64_t settingsKey(const Settings& settings) {
    Key key;
    for (const int number : {settings.grid, settings.cascades, settings.gather.directions,
                             settings.gather.refinedDirections, settings.lightFrames, settings.shadowMapSize})
        key.add(static_cast<std::uint64_t>(number));
    key.add(double{settings.aoDistance});
    return key.value();
}

// The beginning of the bytes. The faces follow, and a hash of all before it.
struct Header {
    std::array<char, 8> magic;
    std::uint32_t version, faces;
    LightKey key;
};
constexpr std::array<char, 8> magic{'V', 'C', 'T', 'L', 'I', 'G', 'H', 'T'};
constexpr std::uint32_t version = 1;  // of the layout, and of what its words mean

std::size_t bytesFor(std::size_t faces) {
    return sizeof(Header) + faces * sizeof(BakedLight::Face) + sizeof(std::uint64_t);
}

// Names what differs, if the light is of another scene.
void requireKey(const LightKey& baked, const LightKey& key, const std::string& name) {
    std::vector<std::string> differing;
    for (const auto& [part, isSame] : {std::pair{"geometry", baked.geometry == key.geometry},
                                       {"materials", baked.materials == key.materials},
                                       {"lights", baked.lights == key.lights},
                                       {"sky", baked.sky == key.sky},
                                       {"settings", baked.settings == key.settings}})
        if (!isSame) differing.emplace_back(part);
    if (!differing.empty())
        throw Error(name + " is baked light of other " + listText(differing) +
                    "; bake it again, with the same options");
}

}  // namespace

LightKey lightKey(const Scene& scene, const DirectionalLight& sun, const Settings& settings) {
    return {geometryKey(scene), materialsKey(scene), lightsKey(scene, sun), skyKey(settings),
            settingsKey(settings)};
}

std::vector<std::uint8_t> bytesOf(const BakedLight& light) {
    std::vector<std::uint8_t> bytes(bytesFor(light.faces.size()));
    const Header header{magic, version, static_cast<std::uint32_t>(light.faces.size()), light.key};
    std::memcpy(bytes.data(), &header, sizeof header);
    std::memcpy(&bytes[sizeof header], light.faces.data(), light.faces.size() * sizeof light.faces[0]);
    const std::size_t end = bytes.size() - sizeof(std::uint64_t);
    const std::uint64_t hash = fnv1a(bytes.data(), end);
    std::memcpy(&bytes[end], &hash, sizeof hash);
    return bytes;
}

BakedLight bakedLightOf(std::span<const std::uint8_t> bytes, const LightKey& key, const std::string& name) {
    Header header{};
    if (bytes.size() >= sizeof header) std::memcpy(&header, bytes.data(), sizeof header);
    if (header.magic != magic) throw Error(name + " is no baked light; make one with `vct bake`");
    if (header.version != version)
        throw Error(name + " is baked light of version " + std::to_string(header.version) +
                    ", but this program reads version " + std::to_string(version) + "; bake it again");
    const std::size_t size = bytesFor(header.faces), end = size - sizeof(std::uint64_t);
    std::uint64_t hash = 0;
    if (bytes.size() == size) std::memcpy(&hash, &bytes[end], sizeof hash);
    if (bytes.size() != size || hash != fnv1a(bytes.data(), end))
        throw Error(name + " is truncated or damaged; bake it again");
    requireKey(header.key, key, name);
    BakedLight light{header.key, std::vector<BakedLight::Face>(header.faces)};
    std::memcpy(light.faces.data(), &bytes[sizeof header], light.faces.size() * sizeof light.faces[0]);
    return light;
}

}  // namespace vct
