// Driver check: counts the texels that check_image_atomics.frag or check_image_swaps.comp left wrong.
#include "lab/driver_check.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(r32ui, binding = 0) readonly uniform highp uimage3D image;

void main() {
    ivec3 texel = ivec3(gl_LocalInvocationID);
    uint first = imageLoad(image, texel).r;
    bool right = VCT_CHECK_SWAPS
                     ? first == 64u
                     : first == 0xFFFFFFFFu && imageLoad(image, texel + ivec3(4, 0, 0)).r == 64u &&
                           imageLoad(image, texel + ivec3(0, 4, 0)).r == 64u;
    if (!right) atomicAdd(words[0], 1u);
    if (gl_LocalInvocationIndex == 0u) atomicAdd(groups[0], 1u);
}
