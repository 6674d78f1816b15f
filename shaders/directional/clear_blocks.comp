// Clears the bits of the faces of blocks that only dynamic objects cover, before a new pose is voxelized.
#include "directional/face_lists.glsl"
#include "shared/frame.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

void main() {
    const uint level = uint(VCT_BRICK_LEVEL);
    uint count = faceCount(level), side = uint(frame.gridSide) >> level;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = commands[level].staticFaces + gl_GlobalInvocationID.x; i < count; i += stride) {
        ListedFace listed = listedFace(level, i);
        uvec3 block = uvec3(listed.voxel);
        uint place = block.x + side * (block.y + side * block.z);
        atomicAnd(faceData[commands[level].firstMask + place / 4u],
                  ~(1u << (8u * (place & 3u) + uint(listed.face))));
    }
}
