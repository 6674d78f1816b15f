// Baked light: the converged light of a scene's static faces, which a later run shows in its first frame.
// Bytes of it have a key of all that the light depends on, so that they are refused for another scene.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/settings.h"
#include "scene/scene.h"

namespace vct {

// Hashes of all that the converged light of static faces depends on. Numbers count to about four digits,
// because compilers for other machines round differently.
struct LightKey {
    std::uint64_t geometry = 0, materials = 0, lights = 0, sky = 0, settings = 0;

    bool operator==(const LightKey& other) const = default;
};
LightKey lightKey(const Scene& scene, const DirectionalLight& sun, const Settings& settings);

struct BakedLight {
    // A face, by its place, and three of the words of shaders/directional/face_irradiance.glsl.
    struct Face {
        std::uint32_t entry;                 // shared::packFace()
        std::array<std::uint32_t, 2> shown;  // VCT_FACE_SHOWN_WORD
        std::uint32_t sight;                 // VCT_FACE_SIGHT_WORD

        bool operator==(const Face& other) const = default;
    };
    LightKey key;
    std::vector<Face> faces;  // by ascending entries
};

constexpr const char* bakedLightExtension = ".vctlight";  // of a file beside that of the scene

std::vector<std::uint8_t> bytesOf(const BakedLight& light);
// Throws vct::Error that begins with `name` if the bytes are none of bytesOf(), are damaged, or are of
// another version or another key.
BakedLight bakedLightOf(std::span<const std::uint8_t> bytes, const LightKey& key, const std::string& name);

}  // namespace vct
