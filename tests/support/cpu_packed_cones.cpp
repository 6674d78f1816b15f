#include "support/cpu_packed_cones.h"

#include <algorithm>
#include <cmath>

#include "support/scenes.h"

namespace vct::test {

namespace {

// A cone this opaque is done (published program: 1 up to rounding).
constexpr double opaque = 0.998;

glm::dvec4 radianceAndOpacity(std::uint32_t word) {
    if (word == 0U) return glm::dvec4(0.0);
    if (shared::voxelLight(word) == 0U) return {0.0, 0.0, 0.0, 1.0};
    return {glm::dvec3(shared::voxelColor(word)) / (31.0 * shared::voxelCount(word)), 1.0};
}

}  // namespace

CpuConeTracer::CpuConeTracer(std::vector<Words> levels, const shared::FrameUniforms& frame)
    : levels_(std::move(levels)),
      frame_(frame),
      grid_(frame.gridSide),
      lastLevel_(static_cast<int>(levels_.size()) - 1) {}

glm::dvec4 CpuConeTracer::sample(const glm::dvec3& positionVolume, int level) const {
    const int side = grid_ >> level;
    const glm::dvec3 texel = positionVolume * static_cast<double>(side) - 0.5;
    const glm::ivec3 first(glm::floor(texel));
    const glm::dvec3 part = texel - glm::dvec3(first);
    glm::dvec4 sum(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        const glm::ivec3 at = first + offset;
        if (glm::any(glm::lessThan(at, glm::ivec3(0))) ||
            glm::any(glm::greaterThanEqual(at, glm::ivec3(side))))
            continue;
        const glm::dvec3 weight = glm::mix(1.0 - part, part, glm::dvec3(offset));
        const std::uint32_t word =
            levels_[level][(static_cast<std::size_t>(at.z) * side + at.y) * side + at.x];
        sum += weight.x * weight.y * weight.z * radianceAndOpacity(word);
    }
    return sum;
}

// Half a voxel beyond the volume no texel of the footprint is inside.
bool CpuConeTracer::seesNothing(const glm::dvec3& positionVolume, int level) const {
    const double margin = 0.5 / (grid_ >> level);
    return glm::any(glm::lessThan(positionVolume, glm::dvec3(-margin))) ||
           glm::any(glm::greaterThan(positionVolume, glm::dvec3(1.0 + margin)));
}

CpuConeTracer::Gather CpuConeTracer::gather(const glm::dvec3& positionVolume, const glm::dvec3& normal,
                                            double reach) const {
    const double voxel = 1.0 / grid_;
    const glm::dvec3 start = positionVolume + 5.0 * voxel * normal;
    // Duff et al. 2017; which way the ring of cones is turned around the normal changes the result.
    const double sign = normal.z >= 0.0 ? 1.0 : -1.0;
    const glm::dvec3 tangent(1.0 - normal.x * normal.x / (sign + normal.z) * sign,
                             -normal.x * normal.y / (sign + normal.z) * sign, -sign * normal.x);
    const glm::dvec3 bitangent = glm::cross(tangent, normal);

    Gather gather;
    for (int cone = 0; cone < 6; ++cone) {
        // Five around the normal at 60 degrees, 72 degrees from one to the next.
        const double turn = 2.0 * pi * (cone - 1) / 5.0;
        const double sine = std::sqrt(0.75);
        const glm::dvec3 direction =
            cone == 0 ? normal
                      : 0.5 * normal + sine * std::sin(turn) * tangent + sine * std::cos(turn) * bitangent;
        const double weight = cone == 0 ? 0.25 : 0.15;
        glm::dvec3 radiance(0.0);
        double transmittance = 1.0;
        double nearTransmittance = 1.0;
        for (int level = 0; level <= lastLevel_ && 1.0 - transmittance < opaque; ++level) {
            const double distance = 2.5 * voxel * std::exp2(level);
            const glm::dvec3 p = start + distance * direction;
            if (distance >= reach || seesNothing(p, level)) break;
            const glm::dvec4 value = sample(p, level);
            ++gather.steps;
            radiance += transmittance * glm::dvec3(value);
            transmittance *= 1.0 - value.a;
            if (distance < frame_.aoDistance) nearTransmittance = transmittance;
        }
        gather.radiance += weight * (radiance + transmittance * glm::dvec3(frame_.skyRadiance));
        gather.ambientVisibility += weight * nearTransmittance;
    }
    return gather;
}

CpuConeTracer::Shadow CpuConeTracer::shadow(const glm::dvec3& positionVolume,
                                            const glm::dvec3& normal) const {
    const double voxel = 1.0 / grid_;
    const glm::dvec3 start = positionVolume + 8.0 * voxel * normal;
    const glm::dvec3 towardsLight(frame_.towardsLight);
    const double ratio = frame_.shadowConeSine / (1.0 - frame_.shadowConeSine);  // eq. 4.8
    Shadow result;
    double transmittance = 1.0;
    double distance = voxel;
    while (distance < std::sqrt(3.0) && 1.0 - transmittance < opaque) {
        const double radius = ratio * distance;
        const glm::dvec3 p = start + (distance + radius) * towardsLight;
        const double level = std::clamp(std::log2(2.0 * radius * grid_), 0.0, lastLevel_ + 0.0);  // eq. 4.7
        const int fine = static_cast<int>(level);
        const int coarse = std::min(fine + 1, lastLevel_);
        if (seesNothing(p, coarse)) break;
        double opacity = sample(p, fine).a;
        if (level > fine) opacity = glm::mix(opacity, sample(p, coarse).a, level - fine);
        ++result.steps;
        transmittance *= 1.0 - opacity;
        // A needle steps as a cone of 2 degrees does, and never by more than half a voxel.
        distance += std::max(radius, std::min(0.0178 * distance, 0.5 * voxel));
    }
    result.light = std::clamp(transmittance, 0.0, 1.0);
    return result;
}

}  // namespace vct::test
