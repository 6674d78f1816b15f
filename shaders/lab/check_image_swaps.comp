// Driver check: compare-and-swap on a 3D image, repeated until it succeeds. 64 invocations of different
// groups count up each of 64 texels.
#include "lab/driver_check.glsl"

layout(local_size_x = 64) in;
layout(r32ui, binding = 0) uniform highp uimage3D image;

void main() {
    ivec3 texel = ivec3(gl_LocalInvocationIndex & 3u, (gl_LocalInvocationIndex >> 2) & 3u,
                        (gl_LocalInvocationIndex >> 4) & 3u);
    // Another invocation has succeeded whenever this one fails, so that 64 attempts are enough. A driver
    // whose operation never succeeds must not hang.
    uint before = 0u;
    for (int attempt = 0; attempt < 64; ++attempt) {
        uint found = imageAtomicCompSwap(image, texel, before, before + 1u);
        if (found == before) {
            if (found == 0u) atomicAdd(words[1], 1u);
            return;
        }
        before = found;
    }
}
