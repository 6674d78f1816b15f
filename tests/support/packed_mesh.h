// A small uneven surface, for tests of mesh compression.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/gltf_builder.h"

namespace vct::test {

// side x side vertices: a bumpy field with unit normals and texture coordinates.
struct BumpyField {
    std::vector<float> positions, normals, uvs;
    std::vector<std::uint32_t> indices;

    explicit BumpyField(std::uint32_t side) {
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x) {
                const float u = static_cast<float>(x) / static_cast<float>(side - 1);
                const float v = static_cast<float>(y) / static_cast<float>(side - 1);
                positions.insert(positions.end(), {4 * u, 0.3F * std::sin(9 * u) * std::cos(7 * v), 3 * v});
                const glm::vec3 normal =
                    glm::normalize(glm::vec3(-0.6F * std::cos(9 * u), 1, 0.7F * std::sin(7 * v)));
                normals.insert(normals.end(), {normal.x, normal.y, normal.z});
                uvs.insert(uvs.end(), {u, v});
                if (x + 1 == side || y + 1 == side) continue;
                const std::uint32_t i = y * side + x;
                indices.insert(indices.end(), {i, i + side, i + 1, i + 1, i + side, i + side + 1});
            }
    }
    std::size_t vertexCount() const { return positions.size() / 3; }
};

// The field as a mesh that is not packed.
inline GltfBuilder plainField(const BumpyField& field) {
    GltfBuilder builder;
    const int mesh = builder.mesh({{"attributes",
                                    {{"POSITION", builder.floats(field.positions)},
                                     {"NORMAL", builder.floats(field.normals)},
                                     {"TEXCOORD_0", builder.floats(field.uvs, "VEC2")}}},
                                   {"indices", builder.accessor(field.indices, uint32, "SCALAR")}});
    builder.node({{"mesh", mesh}});
    return builder;
}

}  // namespace vct::test
