#include "shared/dominant_axis.h"

// Onto the side of the volume, one pixel per voxel column. Cyclic, so that front faces stay front faces.
vec4 projectedAlong(int axis, vec3 position) {
    vec2 projected = axis == VCT_AXIS_X ? position.yz : axis == VCT_AXIS_Y ? position.zx : position.xy;
    return vec4(projected * 2.0 - 1.0, 0.0, 1.0);
}
