#include "shared/dominant_axis.h"

// Onto the side of the volume, one pixel per voxel column. Cyclic, so that front faces stay front faces. What is outside the
// volume is clipped, also before and behind it.
vec4 projectedAlong(int axis, vec3 position) {
    vec3 projected = axis == VCT_AXIS_X ? position.yzx : axis == VCT_AXIS_Y ? position.zxy : position;
    return vec4(projected * 2.0 - 1.0, 1.0);
}
