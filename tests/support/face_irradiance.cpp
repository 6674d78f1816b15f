#include "support/face_irradiance.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "support/faces.h"

namespace vct::test {

IrradianceByFace readIrradiance(const Renderer& renderer) {
    const DirectionalVoxels& voxels = renderer.directional()->voxels();
    const Irradiance& irradiance = *renderer.directional()->irradiance();
    const gl::Buffer& buffer = irradiance.faceIrradiance();
    std::vector<std::uint32_t> words(buffer.bytes() / sizeof(std::uint32_t));
    buffer.read(words.data(), buffer.bytes());
    const Faces base = readFaces(voxels);
    IrradianceByFace faces;
    // shaders/directional/face_irradiance.glsl
    for (const auto& [entry, id] : voxels.readBaseFaces()) {
        FaceIrradiance face;
        const std::size_t at = std::size_t{irradiance.irradianceWords()} * id;
        std::copy_n(words.begin() + static_cast<std::ptrdiff_t>(at), face.words.size(), face.words.begin());
        const auto mean = [&](std::size_t word) {
            const glm::vec2 rg = glm::unpackHalf2x16(words.at(at + word)),
                            ba = glm::unpackHalf2x16(words.at(at + word + 1));
            return glm::dvec4(rg, ba);
        };
        const glm::dvec4 shown = mean(4);
        face.light = glm::dvec3(shown);
        face.ambientVisibility = shown.a;
        const std::uint32_t sight = words.at(at + VCT_FACE_SIGHT_WORD);
        const auto rays = static_cast<int>(sight >> 24U), backs = static_cast<int>(sight >> 16U & 255U);
        const auto blockedBacks = static_cast<int>(words.at(at + VCT_FACE_BLOCKED_COUNTS_WORD) >> 16U & 255U);
        const int counted = std::max(rays - blockedBacks, 0);
        face.rays = rays + backs;
        face.isHidden = 3 * (backs + rays - counted) > counted;
        if (irradiance.irradianceWords() > VCT_FACE_IRRADIANCE_WORDS)
            face.light += unpackRgb9e5(words.at(at + VCT_FACE_IRRADIANCE_WORDS));
        face.coverage = base.at(entry).coverage;
        faces[entry] = face;
    }
    return faces;
}

IrradianceDifference differenceOf(const IrradianceByFace& a, const IrradianceByFace& b) {
    IrradianceDifference result;
    double squares = 0.0, sum = 0.0, differences = 0.0, weights = 0.0;
    for (const auto& [entry, face] : a) {
        const auto other = b.find(entry);
        if (other == b.end()) continue;
        const double difference = face.light.g - other->second.light.g;
        if (other->second.isHidden || face.isHidden) continue;
        const double weight = other->second.coverage;
        ++result.common;
        weights += weight;
        sum += weight * other->second.light.g;
        differences += weight * difference;
        squares += weight * difference * difference;
        if (weight > 0.1) result.largest = std::max(result.largest, std::abs(difference));
    }
    if (weights == 0.0) return result;
    result.mean = sum / weights;
    result.bias = differences / weights;
    result.rms = std::sqrt(squares / weights);
    return result;
}

}  // namespace vct::test
