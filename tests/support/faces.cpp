#include "support/faces.h"

#include <cmath>

#include "support/frame_inspector.h"

namespace vct::test {

glm::dvec3 faceDirection(int face) {
    glm::dvec3 direction(0.0);
    direction[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
    return direction;
}

const char* faceName(int face) {
    static const char* const names[faceCount] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    return names[face];
}

Face faceAt(const Faces& faces, const glm::ivec3& voxel, int face) {
    const auto found = faces.find(shared::packFace(glm::uvec3(voxel), static_cast<std::uint32_t>(face)));
    return found != faces.end() ? found->second : Face{};
}

glm::dvec3 unpackRgb9e5(std::uint32_t word) {
    const glm::dvec3 mantissas(word & 511U, word >> 9U & 511U, word >> 18U & 511U);
    return mantissas * std::exp2(static_cast<double>(word >> 27U) - 24.0);
}

Faces readFaces(const DirectionalVoxels& voxels) {
    std::vector<std::uint32_t> words(voxels.faceData().bytes() / sizeof(std::uint32_t));
    voxels.faceData().read(words.data(), voxels.faceData().bytes());
    Faces faces;
    for (const auto& [entry, id] : voxels.readBaseFaces()) {
        // shaders/directional/face_data.glsl
        const std::uint32_t* const face = &words.at(voxels.faceWord(id));
        const std::uint32_t surface = face[0], extent = face[1];
        faces[entry] = {(extent >> 25U) / 127.0,
                        (surface >> 24U) / 255.0,
                        normalFromCode(surface >> 8U & 255U, surface & 255U, 254.0),
                        (surface >> 16U & 255U) / 127.5 - 1.0,
                        unpackRgb9e5(face[2]),
                        unpackRgb9e5(words.at(voxels.radianceWord(id)))};
    }
    return faces;
}

}  // namespace vct::test
