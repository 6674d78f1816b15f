// Clears the bits of the faces of blocks that only dynamic objects cover, before a new pose is voxelized.
#include "directional/face_lists.glsl"
#include "shared/frame.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

void main() {
    const uint bricks = uint(VCT_BRICK_LEVEL);
    uint count = faceCount(bricks), side = uint(frame.gridSide) >> bricks;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = commands[bricks].staticFaces + gl_GlobalInvocationID.x; i < count; i += stride) {
        ListedFace listed = listedFace(bricks, i);
        uvec3 block = uvec3(listed.voxel);
        uint place = block.x + side * (block.y + side * block.z);
        atomicAnd(faceData[commands[bricks].firstMask + place / 4u],
                  ~(1u << (8u * (place & 3u) + uint(listed.face))));
    }
}
