#include "support/cpu_directional_cones.h"

#include <algorithm>
#include <cmath>

#include "lab/cpu_mips.h"
#include "shared/layout.h"
#include "support/scenes.h"

namespace vct::test {

namespace {

FacePlane unpackPlane(std::uint32_t word) {
    const auto step = [&](int shift) { return static_cast<double>(word >> shift & 255U); };
    // The octahedron unfolded into a square.
    const double x = step(8) / 127.0 - 1.0, y = step(0) / 127.0 - 1.0;
    const double z = 1.0 - std::abs(x) - std::abs(y);
    glm::dvec3 normal(x, y, z);
    if (z < 0.0) normal = {std::copysign(1.0 - std::abs(y), x), std::copysign(1.0 - std::abs(x), y), z};
    return {glm::normalize(normal), step(16) / 127.5 - 1.0};
}

// Hammersley: the hemisphere around +y, weighted by the cosine.
glm::dvec3 directionOf(int i, int directions) {
    double reversed = 0.0;
    for (int bit = 0; bit < 32; ++bit)
        if ((i >> bit & 1) != 0) reversed += std::exp2(-1 - bit);
    const double height = reversed + 0.5 / directions, phi = 2.0 * pi / directions * i;
    return {std::sqrt(height) * std::cos(phi), std::sqrt(1.0 - height), std::sqrt(height) * std::sin(phi)};
}

}  // namespace

std::map<std::uint32_t, FacePlane> readPlanes(const DirectionalVoxels& voxels) {
    std::vector<std::uint32_t> words(voxels.faceData().bytes() / sizeof(std::uint32_t));
    voxels.faceData().read(words.data(), voxels.faceData().bytes());
    std::map<std::uint32_t, FacePlane> planes;
    for (const auto& [entry, id] : voxels.readBaseFaces())
        planes[entry] = unpackPlane(words.at(std::size_t{id} * voxels.faceWords()));
    return planes;
}

// Texels outside a block of faces have the values at its border.
glm::dvec4 CpuFaceCones::faceAt(const glm::dvec3& texel, int face, int level) const {
    const FaceLevel& faces = levels_[static_cast<std::size_t>(level)];
    const glm::dvec3 at = glm::clamp(texel, 0.0, faces.side() - 1.0);
    const glm::ivec3 first(glm::floor(at));
    const glm::dvec3 part = at - glm::dvec3(first);
    glm::dvec4 sum(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        const glm::dvec3 weight = glm::mix(1.0 - part, part, glm::dvec3(offset));
        const glm::ivec3 voxel = glm::min(first + offset, glm::ivec3(faces.side() - 1));
        sum += weight.x * weight.y * weight.z / 255.0 * glm::dvec4(faces.at(voxel, face));
    }
    return sum;
}

CpuFaceCones::Met CpuFaceCones::sample(const glm::dvec3& positionVoxels, const glm::dvec3& direction,
                                       const glm::dvec3& share, int level) const {
    const glm::dvec3 texel = positionVoxels / std::exp2(level) - 0.5;
    glm::dvec4 emitted(0.0);
    double coverage = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        // The face that looks against the ray.
        const glm::dvec4 face = faceAt(texel, 2 * axis + (direction[axis] > 0.0 ? 1 : 0), level);
        emitted += share[axis] * share[axis] * face;
        coverage += share[axis] * face.a;
    }
    return {glm::dvec3(emitted) * (coverage / std::max(emitted.a, 1e-4)), coverage};
}

CpuFaceCones::Gathered CpuFaceCones::trace(const glm::dvec3& start, const glm::dvec3& normal, bool hasBack,
                                           const glm::dvec3& direction, double spread) const {
    const GatherSettings& s = settings_;
    const double grid = levels_[0].side();
    const glm::dvec3 axisShare = glm::abs(direction);
    glm::dvec3 nearShare = axisShare;
    double reach = 2.0 * grid;
    for (int axis = 0; axis < 3; ++axis) {
        const bool isBack = hasBack && std::abs(normal[axis]) >= 0.3;
        if (direction[axis] * normal[axis] < 0.0 || isBack) nearShare[axis] = 0.0;
        const double end = direction[axis] >= 0.0 ? grid : 0.0;
        if (!s.fadesAtBorder) reach = std::min(reach, (end - start[axis]) / direction[axis]);
    }
    const double rise = glm::dot(direction, normal);
    const auto levelAt = [&](double height) {
        return std::clamp(static_cast<int>(std::floor(std::log2(s.height * spread * height))), 0,
                          static_cast<int>(levels_.size()) - 1);
    };
    Gathered result{glm::dvec3(0.0), 1.0};
    bool ended = false;
    for (double distance = s.firstSample; distance < reach && !ended;) {
        const double height = s.startOffset + distance * rise;
        const int level = levelAt(height);
        const double stride = s.step * std::exp2(level);
        const double share = levelAt(height + stride * rise) > level ? s.levelEnd : 1.0;
        const bool near = height < s.ownSurface * std::exp2(level);
        const glm::dvec3 position = start + direction * distance;
        Met met = sample(position, direction, near ? nearShare : axisShare, level);
        if (s.fadesAtBorder) {
            const glm::dvec3 fromCentre = glm::abs(position - 0.5 * grid);
            const double beyond = std::max({fromCentre.x, fromCentre.y, fromCentre.z}) - 0.5 * grid;
            const double inside = 0.5 - beyond / std::exp2(level);
            if (inside <= 0.0) break;
            met.light *= std::min(inside, 1.0);
            met.coverage *= std::min(inside, 1.0);
        }
        const double taken =
            std::min<double>(share * s.extinction * s.step * std::min(met.coverage, 1.0), result.sky);
        result.light += met.light * (taken / std::max(met.coverage, 1e-4));
        result.sky -= taken;
        ended = result.sky < s.threshold;
        distance += stride;
    }
    if (ended) {  // in the rest it met what it met before
        result.light /= 1.0 - result.sky;
        result.sky = 0.0;
    }
    return result;
}

CpuFaceCones::Gathered CpuFaceCones::gather(std::uint32_t face, const FacePlane& plane, const FacePlane* back,
                                            int direction, int cones) const {
    const glm::ivec3 voxel(shared::unpackFaceVoxel(face));
    const int golden = (settings_.directionSet() * 618 / 1000) | 1;
    const glm::dvec3 n = plane.normal;
    const glm::dvec3 start = glm::dvec3(voxel) + 0.5 + n * (plane.offset + settings_.startOffset);
    // Duff et al. 2017.
    const double sign = n.z >= 0.0 ? 1.0 : -1.0, a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    const glm::dvec3 tangent(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    const glm::dmat3 frame(tangent, n, glm::cross(tangent, n));
    const int axis = static_cast<int>(shared::unpackFace(face) >> 1);
    const int first = direction + (voxel[(axis + 1) % 3] & 3) + 4 * (voxel[(axis + 2) % 3] & 3);
    const int number = static_cast<int>(shared::unpackFace(face));
    const bool hasBack = back != nullptr && glm::dot(back->normal, plane.normal) < -0.8 &&
                         levels_[0].at(voxel, number ^ 1).a > 0.5 * levels_[0].at(voxel, number).a;
    Gathered sum;
    const int faceNoise = 4096 * (voxel[(axis + 1) % 3] & 3) + 4 * 4096 * (voxel[(axis + 2) % 3] & 3);
    for (int i = first; i < first + cones; ++i) {
        const int noise = (i & (settings_.directionSet() - 1)) * 49471 + faceNoise;
        const Gathered cone =
            trace(start, n, hasBack,
                  frame * directionOf(i * golden & (settings_.directionSet() - 1), settings_.directionSet()),
                  std::exp2((noise & 65535) / 65536.0 - 0.5));
        sum.light += cone.light / static_cast<double>(cones);
        sum.sky += cone.sky / cones;
    }
    return sum;
}

}  // namespace vct::test
