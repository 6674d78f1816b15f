// The dominant axis of a triangle, along which it is voxelized. Shared by the geometry shader,
// passes/sort_axes.comp and the CPU, which must agree for every triangle, or the voxels differ. IEEE 754 and
// ESSL (4.7.1) define the result of every operation used here. VCT_PRECISE keeps a compiler from fusing or
// reordering them.
#ifndef VCT_SHARED_DOMINANT_AXIS_H
#define VCT_SHARED_DOMINANT_AXIS_H

#include "shared/layout.h"

#ifdef __cplusplus
#define VCT_PRECISE  // the compiler option -ffp-contract=off has this effect
namespace vct::shared {
using glm::abs;
using glm::max;
using glm::vec3;
#elif __VERSION__ >= 320 || defined(GL_EXT_gpu_shader5)
#define VCT_PRECISE precise
#else
#define VCT_PRECISE  // a near tie may be decided differently than on the CPU, which loses no voxel
#endif

#define VCT_AXIS_X 0
#define VCT_AXIS_Y 1
#define VCT_AXIS_Z 2
#define VCT_AXIS_NONE 3  // the triangle has no area

VCT_FUNCTION vec3 positionInVolume(mat4 volumeFromObject, vec3 position) {
    VCT_PRECISE vec3 p = vec3(volumeFromObject[0]) * position.x + vec3(volumeFromObject[1]) * position.y +
                         vec3(volumeFromObject[2]) * position.z + vec3(volumeFromObject[3]);
    return p;
}

// The dominant axis of a triangle's normal (thesis algorithm 7). `a`, `b`, `c`: corners in volume space.
VCT_FUNCTION int dominantAxis(vec3 a, vec3 b, vec3 c) {
    VCT_PRECISE vec3 u = b - a;
    VCT_PRECISE vec3 v = c - a;
    VCT_PRECISE vec3 area = vec3(u.y * v.z - v.y * u.z, u.z * v.x - v.z * u.x, u.x * v.y - v.x * u.y);
    vec3 size = abs(area);
    // Without area there is no normal. The negation also rejects NaN.
    if (!(size.x + size.y + size.z > 0.0f)) return VCT_AXIS_NONE;
    // Faces at exactly 45 degrees are common. The preference makes their axis independent of rounding.
    VCT_PRECISE float preferredX = size.x * 1.0001f;
    VCT_PRECISE float preferredY = size.y * 1.0001f;
    if (preferredX >= max(size.y, size.z)) return VCT_AXIS_X;
    return preferredY >= size.z ? VCT_AXIS_Y : VCT_AXIS_Z;
}

#ifdef __cplusplus
}  // namespace vct::shared
#endif
#endif
