// Along which axis a triangle is voxelized, written once for the geometry shader and for the CPU that sorts triangles
// before: both must decide alike, triangle by triangle, or the voxels differ. Every step is one that IEEE 754 and
// ESSL (4.7.1) round correctly; VCT_PRECISE keeps a compiler from fusing two of them or from changing their order.
#ifndef VCT_SHARED_DOMINANT_AXIS_H
#define VCT_SHARED_DOMINANT_AXIS_H

#include "shared/layout.h"

#ifdef __cplusplus
#define VCT_PRECISE  // the compiler is asked: -ffp-contract=off
namespace vct::shared {
using glm::abs;
using glm::max;
using glm::vec3;
#elif __VERSION__ >= 320 || defined(GL_EXT_gpu_shader5)
#define VCT_PRECISE precise
#else
#define VCT_PRECISE  // a near tie may then be decided differently than on the CPU, by which no voxel is lost
#endif

#define VCT_AXIS_X 0
#define VCT_AXIS_Y 1
#define VCT_AXIS_Z 2
#define VCT_AXIS_NONE 3  // no area: covers nothing

VCT_FUNCTION vec3 positionInVolume(mat4 volumeFromObject, vec3 position) {
    VCT_PRECISE vec3 p = vec3(volumeFromObject[0]) * position.x + vec3(volumeFromObject[1]) * position.y +
                         vec3(volumeFromObject[2]) * position.z + vec3(volumeFromObject[3]);
    return p;
}

// Of the triangle's normal (thesis algorithm 7). `a`, `b`, `c`: corners in the volume.
VCT_FUNCTION int dominantAxis(vec3 a, vec3 b, vec3 c) {
    VCT_PRECISE vec3 u = b - a;
    VCT_PRECISE vec3 v = c - a;
    VCT_PRECISE vec3 area = vec3(u.y * v.z - v.y * u.z, u.z * v.x - v.z * u.x, u.x * v.y - v.x * u.y);
    vec3 size = abs(area);
    // Normalising would give NaN here.
    if (!(size.x + size.y + size.z > 0.0f)) return VCT_AXIS_NONE;
    // Faces at exactly 45 degrees are common; the preference keeps rounding from deciding.
    VCT_PRECISE float preferredX = size.x * 1.0001f;
    VCT_PRECISE float preferredY = size.y * 1.0001f;
    if (preferredX >= max(size.y, size.z)) return VCT_AXIS_X;
    return preferredY >= size.z ? VCT_AXIS_Y : VCT_AXIS_Z;
}

#ifdef __cplusplus
}  // namespace vct::shared
#endif
#endif
