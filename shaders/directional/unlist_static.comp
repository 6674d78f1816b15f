// Removes all static faces from the blocks, and those of cascades that have moved from the index, before
// scroll.comp lists them where they are now. Only with cascades.
#include "directional/cascades.glsl"
#include "directional/face_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform highp uimage3D index;
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit per cascade

void main() {
    COUNT(VCT_COUNTER_UNLIST_STATIC);
    const uint bricks = uint(VCT_BRICK_LEVEL);
    uint count = faceCount(0u), side = uint(frame.gridSide) >> bricks;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint id = gl_GlobalInvocationID.x; id < count; id += stride) {
        COUNT(VCT_COUNTER_UNLIST_STATIC_FACE);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        ivec3 block = listed.voxel >> VCT_BRICK_LEVEL;
        uint bits = blockWords(block, listed.face, false);
        faceData[bits] = 0u;
        faceData[bits + 1u] = 0u;
        uint place = uint(block.x) + side * (uint(block.y) + side * uint(block.z));
        faceData[commands[bricks].firstMask + place / 4u] = 0u;
        if ((moved >> uint(cascadeOf(listed.voxel)) & 1u) != 0u) imageStore(index, listed.voxel, uvec4(0u));
    }
}
