// Writes the texture of occupied voxels that rays read: those of the static geometry, and behind them along z
// those of the dynamic objects, if there are any. A ray meets only faces that look against it, so each of the
// eight octants of directions has 64 bits per block, of the voxels with such faces: bit x + 4 y of channel z.
// Bits 0, 1 and 2 of an octant's number are set if its directions point towards +x, +y and +z. A ninth set
// has the voxels with any face.
#include "directional/face_data.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(rgba16ui, binding = VCT_IMAGE_BLOCKS) writeonly uniform highp uimage3D blocks;

layout(location = VCT_UNIFORM_CASCADES) uniform uint changed;  // a bit per cascade

void storeBits(ivec3 texel, uvec2 bits) {
    imageStore(blocks, texel, uvec4(bits.x & 0xFFFFu, bits.x >> 16u, bits.y & 0xFFFFu, bits.y >> 16u));
}

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int side = frame.gridSide / VCT_BRICK_SIDE, depth = side * cascades;
    if (any(greaterThanEqual(texel, ivec3(side, side, imageSize(blocks).z)))) return;
    bool isDynamic = texel.z >= depth;
    if (!isDynamic && (changed >> uint(texel.z / side) & 1u) == 0u) return;
    uvec2 faces[6];
    for (int face = 0; face < 6; ++face) {
        uint at = blockWords(texel - ivec3(0, 0, isDynamic ? depth : 0), face, isDynamic);
        faces[face] = uvec2(faceData[at], faceData[at + 1u]);
    }
    uvec2 all = uvec2(0u);
    for (int octant = 0; octant < 8; ++octant) {
        uvec2 bits = faces[octant & 1] | faces[2 + (octant >> 1 & 1)] | faces[4 + (octant >> 2 & 1)];
        storeBits(texel + ivec3(placeOfSet(octant) * side, 0), bits);
        all |= bits;
    }
    storeBits(texel + ivec3(placeOfSet(allFaces) * side, 0), all);
}
