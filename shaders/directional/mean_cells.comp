// Writes the mean irradiance of the faces of each cell, for surfaces whose block has none
// (directional/irradiance.glsl). A work group computes one cell.
#include "directional/irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba16f, binding = VCT_IMAGE_IRRADIANCE) writeonly uniform mediump image3D irradianceTexels;

shared vec4 sums[VCT_LIST_GROUP];

void main() {
    ivec3 cell = ivec3(gl_WorkGroupID);
    int side = (frame.gridSide >> VCT_BRICK_LEVEL) / VCT_CELLS, first = int(gl_LocalInvocationIndex);
    vec4 sum = vec4(0.0);
    for (int i = first; i < side * side * side; i += VCT_LIST_GROUP)
        for (int face = 0; face < 6; ++face) {
            ivec3 block = cell * side + ivec3(i % side, i / side % side, i / (side * side));
            uint brick = brickAt(block, face >> 1, face & 1);
            if (brick != 0u) sum += texelFetch(irradiance, meanTexel(brick), 0);
        }
    sums[first] = sum;
    for (int count = VCT_LIST_GROUP / 2; count > 0; count /= 2) {
        barrier();
        if (first < count) sums[first] += sums[first + count];
    }
    if (first != 0) return;
    int cascade = cell.z / VCT_CELLS;
    cell.z -= VCT_CELLS * cascade;
    imageStore(irradianceTexels, firstCell(cascade) + cell, min(sums[0] / float(side * side), vec4(maxMean)));
}
