// The faces that are not empty, listed per level: most voxels have one or two of six, and a pass over voxels would idle
// at the others. Each level's list has room for all six faces of every voxel, so it cannot overflow where the list of
// voxels does not. It lies in the buffer of the sums, as stages may have no more than four storage buffers.
#include "shared/commands.glsl"
#include "shared/face_sums.glsl"

// To be called once per face that is not empty.
void appendFace(uint level, uvec3 voxel, uint face) {
    uint index = atomicAdd(commands[level].faceCount, 1u);
    if (index >= commands[level].faceCapacity) return;
    faceSums[commands[level].firstFace + index] = packFace(voxel, face);
    if (index % uint(VCT_LIST_GROUP) == 0u && index / uint(VCT_LIST_GROUP) < VCT_MAX_GROUPS)
        atomicAdd(commands[level].faceGroupsX, 1u);
}

uint faceCount(uint level) {
    return min(commands[level].faceCount, commands[level].faceCapacity);
}

struct ListedFace {
    ivec3 voxel;
    int face;  // 0..5: +x, -x, +y, -y, +z, -z
};

ListedFace listedFace(uint level, uint i) {
    uint entry = faceSums[commands[level].firstFace + i];
    return ListedFace(ivec3(unpackFaceVoxel(entry)), int(unpackFace(entry)));
}

// Occupied voxels that have sums.
uint faceSlots() {
    return commands[0].faceCapacity / 6u;
}
