// The face lists. Most voxels have one or two of six faces, so passes iterate over faces and not over voxels.
//
// At the base level, static geometry and dynamic objects have separate lists. The position in these lists
// gives a face its id, which locates its sums and its irradiance. Static faces have the first ids and keep
// them as long as a cascade holds them; ids that a cascade leaves behind as it moves are used again. Two
// ranges of ids for dynamic faces follow. They alternate from pose to pose, so that a new pose can read the
// last one. The list of VCT_BRICK_LEVEL holds the faces of blocks: the static ones, then those that only
// dynamic objects cover.
#include "directional/face_data.glsl"
#include "shared/commands.glsl"

struct ListedFace {
    ivec3 voxel;
    int face;       // 0..5: +x, -x, +y, -y, +z, -z
    bool isMerged;  // a dynamic face whose sums are added to a static face's, or an id without a face
};

ListedFace unpackListed(uint entry) {
    return ListedFace(ivec3(unpackFaceVoxel(entry)), int(unpackFace(entry)), (entry & VCT_MERGED_FACE) != 0u);
}

uint faceCount(uint list) {
    return min(commands[list].faceCount, commands[list].faceCapacity);
}
ListedFace listedFace(uint list, uint i) {
    return unpackListed(faceData[commands[list].firstFace + i]);
}

// The number of ids of the base level's faces in use or free, static and dynamic, and each of them.
uint baseFaceCount() {
    return faceCount(0u) + faceCount(dynamicList);
}
uint baseFaceId(uint i) {
    uint staticCount = faceCount(0u);
    return i < staticCount ? i : commands[dynamicList].firstId + i - staticCount;
}
ListedFace baseFace(uint id) {
    return listedFace(0u, id);
}

// The work groups of a dispatch over dynamic faces alone, if these fill `groups`. Few faces have more groups,
// because invocations share their rays (directional/trace_moving.comp).
uint groupsForDynamic(uint groups) {
    return max(min(8u * groups, 64u), groups);
}

// Reserves `count` entries at the end of a list, at most VCT_LIST_GROUP, and returns the position of the
// first. The dispatch over the base level covers static and dynamic faces.
uint reserveFaces(uint list, uint count) {
    uint first = atomicAdd(commands[list].faceCount, count);
    uint group = (first + uint(VCT_LIST_GROUP) - 1u) / uint(VCT_LIST_GROUP);  // the next new work group
    if (group * uint(VCT_LIST_GROUP) < first + count && group < VCT_MAX_GROUPS / 2u) {
        bool isDynamic = (list & ~1u) == uint(VCT_LIST_DYNAMIC);
        atomicAdd(commands[list].faceGroupsX,
                  isDynamic ? groupsForDynamic(group + 1u) - groupsForDynamic(group) : 1u);
        if (isDynamic) atomicAdd(commands[0].faceGroupsX, 1u);
    }
    return first;
}

// Static ids have three bits each: set if the id may be used again, if its face has no light yet
// (directional/carry_over.comp), and if a face is gone whose id cached hits still have
// (directional/forward_hits.comp).
uint freeAt(uint id) {
    return commands[0].firstMask + id / 32u;
}
uint freshAt(uint id) {
    return freeAt(id) + (commands[0].faceCapacity + 31u) / 32u;
}
uint goneAt(uint id) {
    return freshAt(id) + (commands[0].faceCapacity + 31u) / 32u;
}
bool isFresh(uint id) {
    return (faceData[freshAt(id)] >> (id & 31u) & 1u) != 0u;
}
bool isFree(uint id) {
    return (faceData[freeAt(id)] >> (id & 31u) & 1u) != 0u;
}
// True if the face that had a static id is gone; another one may have the id by now.
bool isGone(uint id) {
    return faceData[commands[0].firstFace + id] == VCT_FREE_FACE || isFresh(id);
}
// The id, counted from 1, of the face that is in the place of one that is gone; 0: unknown.
uint faceInstead(uint id) {
    uint other = isFresh(id) ? 0u : faceData[faceAt(id) + VCT_FACE_INSTEAD];
    return other == 0u || isGone(other - 1u) ? 0u : other;
}
// The bits of `count` ids from `first` on, in the word of `first` or in the next one.
uint bitsOfIds(uint first, uint count, uint inWord) {
    uint bits = (1u << count) - 1u, shift = first & 31u;
    return inWord == 0u ? bits << shift : shift == 0u ? 0u : bits >> (32u - shift);
}
const uint noIds = 0xFFFFFFFFu;
#if VCT_CASCADES > 1
// Takes `count` successive free ids, 1 to 6, and returns the first; noIds if a search finds none. The words
// of bits in which ids are free are listed where the faces that light steps visit will be (list_free.comp).
uint takeFreeIds(uint count) {
    const uint mostWords = 512u;  // of a search
    uint words = faceCount(uint(VCT_LIST_VISITED)), start = atomicAdd(takenIds, count);
    for (uint n = 0u; n < min(words, mostWords); ++n) {
        uint word = faceData[commands[VCT_LIST_VISITED].firstFace + (start + n) % words];
        uint at = commands[0].firstMask + word, free = faceData[at];
        // Each failed attempt means that another invocation has taken bits of the word.
        for (int attempt = 0; attempt < 32; ++attempt) {
            uint firsts = free;
            for (uint i = 1u; i < count; ++i)
                firsts &= free >> i;
            if (firsts == 0u) break;
            uint place = uint(findLSB(firsts)), bits = ((1u << count) - 1u) << place;
            free = atomicAnd(faceData[at], ~bits);
            if ((free & bits) == bits) return 32u * word + place;
            atomicOr(faceData[at], free & bits);
            free &= ~bits;
        }
    }
    return noIds;
}
#endif

void storeListed(uint list, uint i, ivec3 voxel, int face, uint flags) {
    if (i < commands[list].faceCapacity)
        faceData[commands[list].firstFace + i] = packFace(uvec3(voxel), uint(face)) | flags;
}
