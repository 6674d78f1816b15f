// The projection of triangles for voxelization.
#include "shared/dominant_axis.h"

// Projects a position onto a side of the volume, one pixel per column of voxels. Axes are permuted
// cyclically, which keeps front faces front faces. Everything outside of the volume is clipped.
vec4 projectedAlong(int axis, vec3 position) {
    vec3 projected = axis == VCT_AXIS_X ? position.yzx : axis == VCT_AXIS_Y ? position.zxy : position;
    return vec4(projected * 2.0 - 1.0, 1.0);
}
