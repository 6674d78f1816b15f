// The faces that are not empty, listed per level: most voxels have one or two of six, and a pass over voxels would idle
// at the others. Each level's list has room for all six faces of every voxel, so it cannot overflow where the list of
// voxels does not. It lies in the buffer of the sums, as stages may have no more than four storage buffers.
#include "shared/commands.glsl"
#include "directional/face_sums.glsl"
#include "shared/counters.glsl"

// Makes room for `count` faces of a level that are not empty, at most VCT_LIST_GROUP, and returns the first one's place.
uint reserveFaces(uint level, uint count) {
    uint first = atomicAdd(commands[level].faceCount, count);
    uint group = (first + uint(VCT_LIST_GROUP) - 1u) / uint(VCT_LIST_GROUP);  // the next to begin
    if (group * uint(VCT_LIST_GROUP) < first + count && group < VCT_MAX_GROUPS) atomicAdd(commands[level].faceGroupsX, 1u);
    return first;
}

void listFace(uint level, ivec3 voxel, int face) {
    faceSums[commands[level].firstFace + reserveFaces(level, 1u)] = packFace(uvec3(voxel), uint(face));
}

// Lists the faces of a voxel that are not empty (bits). `trips`: the counter of its loop.
void listFaces(uint level, ivec3 voxel, uint faces, int trips) {
    uint index = commands[level].firstFace + reserveFaces(level, uint(bitCount(faces)));
    for (uint left = faces; left != 0u; left &= left - 1u) {
        COUNT(trips);
        faceSums[index++] = packFace(uvec3(voxel), uint(findLSB(left)));
    }
}

uint faceCount(uint level) {
    return min(commands[level].faceCount, commands[level].faceCapacity);
}

struct ListedFace {
    ivec3 voxel;
    int face;  // 0..5: +x, -x, +y, -y, +z, -z
};

ListedFace unpackListed(uint entry) {
    return ListedFace(ivec3(unpackFaceVoxel(entry)), int(unpackFace(entry)));
}

ListedFace listedFace(uint level, uint i) {
    return unpackListed(faceSums[commands[level].firstFace + i]);
}

// Those that a pass visits, as visitedCount() and visitedEntry() do.
#ifdef VCT_PART
uint visitedFaces(uint level) {
    return partVisited(faceCount(level));
}
ListedFace visitedFace(uint level, uint i) {
    if (isMoving(i)) return listedFace(level, firstMoving + i - staticVisited());
    return unpackListed(staticEntries[firstStatic + i]);
}
#else
uint visitedFaces(uint level) {
    return faceCount(level);
}
ListedFace visitedFace(uint level, uint i) {
    return listedFace(level, i);
}
#endif

// Occupied voxels that have sums.
uint voxelPlaces() {
    return commands[0].faceCapacity / 6u;
}
