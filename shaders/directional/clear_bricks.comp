// Clears the locations of the bricks of face irradiance that are placed again, and the static walls of blocks
// that have come into their cascade. The bricks themselves are cleared where they are placed.
#include "directional/face_data.glsl"
#include "directional/walls.glsl"
#include "shared/commands.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(r32ui, binding = VCT_IMAGE_BRICK_PLACES) writeonly uniform highp uimage3D brickPlaces;
#if VCT_CASCADES == 1
layout(r32ui, binding = VCT_IMAGE_STATIC_WALLS) writeonly uniform highp uimage3D staticWalls;
#endif
layout(location = VCT_UNIFORM_PLACED) uniform uint placed;  // a bit per cascade whose bricks are placed
layout(location = VCT_UNIFORM_ARRIVED) uniform uvec2 arrived[VCT_MAX_CASCADES];  // isNearArrived()

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID), size = imageSize(brickPlaces);
    if (any(greaterThanEqual(texel, size))) return;
    int side = frame.gridSide >> VCT_BRICK_LEVEL, cascade = texel.z / side;
    if ((placed >> uint(cascade) & 1u) != 0u) {
        imageStore(brickPlaces, texel, uvec4(0u));
        if (texel == ivec3(0, 0, cascade * side)) brickLayers[cascade] = 0u;
    }
    ivec3 block = ivec3(texel.x % side, texel.y % side, texel.z);
    if (!isNearArrived(block, VCT_BRICK_SIDE, arrived[cascade], 0)) return;
    int face = 2 * (texel.x / side) + texel.y / side;  // of faceTexel()
    for (int word = 0; word < 2; ++word) {
#if VCT_CASCADES == 1
        imageStore(staticWalls, wallTexel(texel, word, size.z), uvec4(0u));
#else
        uint at = staticWallAt(block, face, word);
        if (at != 0u) faceData[at] = 0u;
#endif
    }
}
