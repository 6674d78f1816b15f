// The faces of directional voxels on the CPU.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>

#include "engine/directional/directional_voxels.h"

namespace vct::test {

// A direction along an axis: 0..5 for +x, -x, +y, -y, +z, -z.
constexpr int faceCount = 6;
glm::dvec3 faceDirection(int face);
const char* faceName(int face);

// The surface that covers a face.
struct Face {
    double coverage = 0.0;   // of the voxel's cross-section
    double opacity = 0.0;    // of the covered part
    glm::dvec3 normal{0.0};  // of its plane
    double offset = 0.0;     // of its plane from the voxel's middle, along the normal, in voxels
    glm::dvec3 albedo{0.0};
    glm::dvec3 radiance{0.0};  // relative to E/pi
};

// The faces of the base level by shared::packFace(voxel, face).
using Faces = std::map<std::uint32_t, Face>;
// A face that no surface covers has the coverage 0.
Face faceAt(const Faces& faces, const glm::ivec3& voxel, int face);
Faces readFaces(const DirectionalVoxels& voxels);

// The three channels of packRgb9e5() in shaders/directional/face_data.glsl.
glm::dvec3 unpackRgb9e5(std::uint32_t word);

}  // namespace vct::test
