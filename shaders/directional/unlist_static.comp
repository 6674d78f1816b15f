// Removes the static faces of cascades that have moved from the blocks, and lists the first one of each of
// their voxels for scroll.comp, in VCT_LIST_VISITED. The voxels of the other cascades are counted. The ids
// without a face may be used from now on. Copies the positions of the blocks' pages to where marked blocks
// will be listed, for list_blocks.comp. Only with cascades.
#include "directional/block_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit per cascade

bool isMoved(uint entry) {
    return (moved >> uint(cascadeOf(unpackListed(entry).voxel)) & 1u) != 0u;
}
bool isFirst(uint entry) {
    return entry != VCT_FREE_FACE && (entry & VCT_FIRST_FACE) != 0u;
}

// An invocation lists the voxels that it finds together, because atomic operations on one word take long.
const uint perInvocation = 16u;

void main() {
    uint blocks = blockCount(), invocations = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint block = gl_GlobalInvocationID.x; block < blocks; block += invocations)
        activeVoxels[commands[VCT_BRICK_LEVEL].firstEntry + block] = faceData[pageAt(block)];
    uint total = faceCount(0u), list = commands[0].firstFace;
    const uint perGroup = perInvocation * uint(VCT_LIST_GROUP);
    uint stride = gl_NumWorkGroups.x * perGroup;
    for (uint base = gl_WorkGroupID.x * perGroup; base < total; base += stride) {
        uint begin = base + gl_LocalInvocationIndex, end = min(base + perGroup, total);
        uint still = 0u, moving = 0u;
        for (uint id = begin; id < end; id += uint(VCT_LIST_GROUP)) {
            uint entry = faceData[list + id];
            if (entry == VCT_FREE_FACE && !isFree(id)) atomicOr(faceData[freeAt(id)], 1u << (id & 31u));
            // It has neither light nor sums (directional/face_sums.glsl).
            if (isFresh(id)) faceData[radianceAt(id)] = 0u;
            if (isFirst(entry) && isMoved(entry))
                ++moving;
            else if (isFirst(entry))
                ++still;
            ListedFace listed = unpackListed(entry);
            if (listed.isMerged || !isMoved(entry)) continue;
            ivec3 block = listed.voxel >> VCT_BRICK_LEVEL;
            uint shift;
            faceData[maskAt(block, shift)] = 0u;  // the other blocks of the word are of the same cascade
        }
        if (still != 0u) atomicAdd(commands[0].voxelCount, still);
        uint i = moving == 0u ? 0u : reserveFaces(uint(VCT_LIST_VISITED), moving);
        for (uint id = begin; id < end && moving != 0u; id += uint(VCT_LIST_GROUP)) {
            uint entry = faceData[list + id];
            if (isFirst(entry) && isMoved(entry)) faceData[commands[VCT_LIST_VISITED].firstFace + i++] = id;
        }
    }
}
