// Lists the faces that mark_faces.frag has marked, which gives them their ids, their voxels, and the faces of
// their blocks. An invocation visits a layer of a block. Of the static geometry these are the voxels without
// ids.
#include "directional/block_lists.glsl"
#include "directional/face_sums.glsl"
#include "directional/index.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform highp uimage3D index;  // of the faces in `list`,
                                                                                   // unless they have pages
layout(rgba16ui, binding = VCT_IMAGE_PAGES) writeonly uniform highp uimage3D pages;
layout(location = VCT_UNIFORM_LIST) uniform uint list;

// The position in the list of the first of `count` faces; noIds if there is no room.
uint placeOf(uint count) {
    if (list != 0u || commands[0].faceCount < commands[0].faceCapacity) {
        uint first = reserveFaces(list, count);
        if (first + count <= commands[list].faceCapacity) return first;
    }
    if (list != 0u) return noIds;
    uint found = noIds;
#if VCT_CASCADES > 1
    found = takeFreeIds(count);
#endif
    if (found == noIds) atomicAdd(unplacedFaces, count);
    return found;
}

// The position, counted from 1, of the sums of `count` faces that come into a cascade, which begin at 0;
// noIds if there is no room. 0: the faces are not in that room.
uint placeOfSums(uint count) {
    if (VCT_CASCADES == 1 || list != 0u || sumsById != 0u) return 0u;
    uint place = atomicAdd(takenSums, count);
    if (place + count > staticSums) return noIds;
    for (uint word = place * faceSumWords; word < (place + count) * faceSumWords; ++word)
        faceSumData[word] = 0u;
    return place + 1u;
}

// True if the index of the faces in `list` is in the pages of cascades.
bool isPaged() {
    return cascades > 1 && list == 0u;
}
// Moves the marks of a layer of a block to its page: those of the voxels in `kept`, a bit for each.
void moveMarks(uint words, uint page, uint z, uint kept) {
    uint shift = 16u * (z & 1u);
    for (uint face = 0u; face < 6u; ++face) {
        uint bits = faceData[words + 2u * face] >> shift & 0xFFFFu;
        if (bits == 0u) continue;
        atomicAnd(faceData[words + 2u * face], ~(bits << shift));
        if ((bits & kept) == 0u) continue;
        atomicOr(faceData[page + VCT_PAGE_BITS + 2u * face + (z >> 1u)], (bits & kept) << shift);
    }
}

// Lists a voxel and its faces. Returns its cell, 0 if there is no room.
uint listVoxel(ivec3 voxel, uint known, bool hasPage) {
    bool isDynamic = list != 0u;
    uint faces = markedFaces(voxel, isDynamic);
    if (known == 0u) atomicAdd(commands[0].voxelCount, 1u);
    uint count = uint(bitCount(faces)), sums = placeOfSums(count);
    uint first = sums == noIds ? noIds : placeOf(count), i = first;
    bool fits = first != noIds && hasPage;
    for (uint left = faces; left != 0u && fits; left &= left - 1u) {
        int face = findLSB(left);
        uint flags = i == first ? VCT_FIRST_FACE : 0u;
        if (sums != 0u) faceData[radianceAt(i)] = sums++;
        storeListed(list, i++, voxel, face, flags | (hasFace(known, face) ? VCT_MERGED_FACE : 0u));
    }
    if (VCT_CASCADES > 1 && !isDynamic && fits)
        for (uint word = 0u; word < 2u; ++word)
            atomicOr(faceData[freshAt(first) + word], bitsOfIds(first, count, word));
    if (!fits) unmarkInBlock(voxel, isDynamic);
    // The first voxel that sets the bit of a block's face lists it.
    uint shift, at = maskAt(voxel >> VCT_BRICK_LEVEL, shift), listed = faces & ~known;
    uint before = atomicOr(faceData[at], listed << shift) >> shift;
    listOfBlock(voxel >> VCT_BRICK_LEVEL, listed & ~before);
    return fits ? packCell(commands[list].firstId + first, faces) : 0u;
}

void main() {
    bool isDynamic = list != 0u;
    const uint level = uint(VCT_BRICK_LEVEL), layers = uint(VCT_BRICK_SIDE);
    uint count = layers * activeVoxelCount(level), side = uint(frame.gridSide) >> level;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint n = gl_GlobalInvocationID.x; n < count; n += stride) {
        uint z = n % layers, number = n / layers + 1u;
        ivec3 block = ivec3(activeVoxel(level, n / layers)), page = ivec3(0);
        if (isDynamic) page = ivec3(number % side, number / side % side, number / (side * side)) << level;
        // There are as many pages as dynamic faces have room, so that pages run out only if faces do.
        bool hasPage = !isDynamic || page.z < imageSize(index).z;
        uint staticPage = isPaged() ? faceData[pageAt(numberOfBlock(block))] : 0u;
        if (isPaged()) hasPage = staticPage != 0u;
        uint shift, at = maskAt(block, shift);
        if (z == 0u) atomicAnd(faceData[at], ~(VCT_MARKED_BLOCK << shift));
        uint occupied = 0u, words = markWords(block, 0, isDynamic) + (z >> 1u);
        for (uint face = 0u; face < 6u; ++face)
            occupied |= faceData[words + 2u * face] >> (16u * (z & 1u)) & 0xFFFFu;
        for (uint left = isDynamic ? ~occupied & 0xFFFFu : 0u; left != 0u; left &= left - 1u) {
            int i = findLSB(left);
            imageStore(index, page + ivec3(i & 3, i >> 2, z), uvec4(0u));
        }
        uint listedVoxels = 0u;
        for (uint left = occupied; left != 0u; left &= left - 1u) {
            int i = findLSB(left);
            ivec3 inBlock = ivec3(i & 3, i >> 2, z), voxel = (block << level) + inBlock;
            uint known = staticCellAt(voxel);
            if (!isDynamic && known != 0u) continue;
            uint cell = listVoxel(voxel, known, hasPage);
            if (!isPaged())
                imageStore(index, isDynamic ? page + inBlock : voxel, uvec4(cell));
            else if (hasPage)
                faceData[staticPage + bitInBlock(voxel)] = cell;
            if (cell != 0u) listedVoxels |= 1u << uint(i);
        }
        if (isPaged()) moveMarks(words, staticPage, z, listedVoxels);
        if (isDynamic && listedVoxels != 0u) imageStore(pages, block, uvec4(page, 0));
    }
}
