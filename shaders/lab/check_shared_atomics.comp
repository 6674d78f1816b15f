// Driver check: atomic operations on shared variables, as the sums of light use them.
#include "lab/driver_check.glsl"

layout(local_size_x = 64) in;
shared uint sum, largest, bits;

void main() {
    uint index = gl_LocalInvocationIndex;
    if (index == 0u) {
        sum = 0u;
        largest = 0u;
        bits = 0u;
    }
    memoryBarrierShared();
    barrier();
    atomicAdd(sum, index);
    atomicMax(largest, index ^ 42u);
    atomicOr(bits, 1u << (index & 31u));
    memoryBarrierShared();
    barrier();
    if (index != 0u) return;
    atomicAdd(words[0], 1u);
    if (sum != 2016u || largest != 63u || bits != 0xFFFFFFFFu) atomicAdd(words[1], 1u);
    atomicAdd(groups[0], 1u);
}
