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
        for (std::size_t w = 0; w < face.words.size(); ++w)
            face.words[w] = words.at(VCT_LIGHT_HEADER + irradiance.irradianceWords() * id + w);
        const glm::vec2 rg = glm::unpackHalf2x16(face.words[0]), bSteps = glm::unpackHalf2x16(face.words[1]);
        face.light = {rg.x, rg.y, bSteps.x};
        if (irradiance.irradianceWords() == 7) {  // the light of emitters is apart
            const std::uint32_t* const emitters = &words.at(VCT_LIGHT_HEADER + 7 * id + 5);
            face.light += glm::dvec3(glm::unpackHalf2x16(emitters[0]), glm::unpackHalf2x16(emitters[1]).x);
        }
        face.steps = bSteps.y;
        face.ambientVisibility = glm::unpackHalf2x16(face.words[4]).x;
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
