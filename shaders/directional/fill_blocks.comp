// Writes the texture of occupied voxels that rays read: those of the static geometry, and behind them along z
// those of the dynamic objects, if there are any. A block has 64 bits: bit x + 4 y of channel z.
#include "directional/face_data.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(rgba16ui, binding = VCT_IMAGE_BLOCKS) writeonly uniform highp uimage3D blocks;

layout(location = VCT_UNIFORM_CASCADES) uniform uint changed;  // a bit per cascade

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int side = frame.gridSide / VCT_BRICK_SIDE, depth = side * cascades;
    if (any(greaterThanEqual(texel, ivec3(side, side, imageSize(blocks).z)))) return;
    bool isDynamic = texel.z >= depth;
    if (!isDynamic && (changed >> uint(texel.z / side) & 1u) == 0u) return;
    uvec2 bits = uvec2(0u);
    for (int face = 0; face < 6; ++face)
        bits |= blockBits(texel - ivec3(0, 0, isDynamic ? depth : 0), face, isDynamic);
    imageStore(blocks, texel, uvec4(bits.x & 0xFFFFu, bits.x >> 16u, bits.y & 0xFFFFu, bits.y >> 16u));
}
