// Driver check: the samples of a pixel that a triangle covers, as voxelization reads them. The triangles
// cover all samples of the target.
#include "lab/driver_check.glsl"

void main() {
    atomicAdd(words[0], uint(bitCount(gl_SampleMaskIn[0])));
}
