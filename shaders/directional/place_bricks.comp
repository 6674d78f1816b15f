// Assigns a brick of face irradiance to each occupied face of the level whose voxels are blocks. The brick's
// walls are the static ones, until mark_walls.comp adds those of dynamic objects.
#include "directional/face_lists.glsl"
#include "directional/voxels.glsl"
#include "directional/light_step.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_BRICKS) writeonly uniform highp uimage3D brickSlots;
layout(r32ui, binding = VCT_IMAGE_WALLS) writeonly uniform highp uimage3D walls;
layout(binding = VCT_TEX_WALLS) uniform highp usampler3D staticWalls;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // VCT_BRICK_LEVEL

void main() {
    COUNT(VCT_COUNTER_PLACE_BRICKS);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    uint along = lightStep.bricksAlong;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_PLACE_BRICKS_FACE);
        ListedFace listed = listedFace(level, i);
        uint brick = packBrick(uvec3(i % along, i / along % along, i / (along * along)));
        ivec3 texel = faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, imageSize(brickSlots).x / 3);
        uint ownWalls = texelFetch(staticWalls, texel, 0).r;
        if (ownWalls != 0u) brick |= VCT_BRICK_HAS_WALLS;
        imageStore(brickSlots, texel, uvec4(brick));
        imageStore(walls, texel, uvec4(ownWalls));
    }
}
