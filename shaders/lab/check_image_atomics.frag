// Driver check: atomic operations of fragments on a 3D image, as voxelization uses them. 64 fragments meet in
// each of 64 texels, with one operation in each of three blocks of the image.
#include "lab/driver_check.glsl"

layout(r32ui, binding = 0) uniform highp uimage3D image;

void main() {
    uint pixel = uint(gl_FragCoord.y) * 64u + uint(gl_FragCoord.x);
    ivec3 texel = ivec3(pixel & 3u, (pixel >> 2) & 3u, (pixel >> 4) & 3u);
    uint turn = pixel >> 6;  // of the fragment among those of the texel, from 0 to 63
    // Voxelization lists a voxel if its own operation found 0, so one fragment per texel must.
    if (imageAtomicOr(image, texel, 1u << (turn & 31u)) == 0u) atomicAdd(words[1], 1u);
    if (imageAtomicMax(image, texel + ivec3(4, 0, 0), turn + 1u) == 0u) atomicAdd(words[1], 1u);
    if (imageAtomicAdd(image, texel + ivec3(0, 4, 0), 1u) == 0u) atomicAdd(words[1], 1u);
}
