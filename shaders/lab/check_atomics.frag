// Driver check: atomic operations of fragments on a storage buffer, as voxelization uses them.
#include "lab/driver_check.glsl"

void main() {
    uint pixel = uint(gl_FragCoord.y) * 64u + uint(gl_FragCoord.x);
    atomicAdd(words[0], pixel);
    atomicMax(words[1], pixel ^ 2730u);
    atomicOr(words[2], 1u << (pixel & 31u));
    // All fragments must get different positions, whose sum is known.
    uint place = atomicAdd(words[3], 1u);
    atomicAdd(words[4], place);
    if ((place & 63u) == 0u) atomicAdd(groups[0], 1u);
}
