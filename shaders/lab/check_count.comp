// Driver check: counts the invocations of an indirect dispatch.
#include "lab/driver_check.glsl"

layout(local_size_x = 64) in;

void main() {
    atomicAdd(words[63], 1u);
}
