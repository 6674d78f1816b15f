// Gives the faces of dynamic objects in a new pose the light and the hits of the last pose: those of the same
// face, or else of a neighbouring one, dynamic in the last pose or static. If cascades have moved with the
// camera, static faces come first: those that are new to a cascade (list_fresh.comp) take over the light of a
// coarser one, that of emitters as well, without its hits. carry_hits.comp follows.
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"
#include "directional/index.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_PREVIOUS_VOXELS) uniform highp usampler3D previousIndex;
layout(binding = VCT_TEX_PREVIOUS_PAGES) uniform highp usampler3D previousPages;
layout(location = VCT_UNIFORM_LIST) uniform uint list;

// The voxel's place before the cascades moved, in its own cascade or in a coarser one. A static voxel is in
// its place, and one that is new to its cascade is looked for in the next one.
struct LastPlace {
    ivec3 voxel;
    bool isSame;  // in its own cascade
};
LastPlace lastPlaceOf(ivec3 voxel) {
    if (cascades == 1) return LastPlace(voxel, true);
    int own = cascadeOf(voxel), cascade = list == 0u ? min(own + 1, cascades - 1) : own;
    vec3 middle = volumeFromVoxels(vec3(voxel) + 0.5, own);
    while (list != 0u && cascade < cascades - 1 && voxelsInside(middle, frame.lastCascade[cascade]) <= 0.0)
        ++cascade;
    vec4 cube = list == 0u ? frame.cascade[cascade] : frame.lastCascade[cascade];
    ivec3 first = ivec3(0, 0, cascade * frame.gridSide);
    ivec3 last = first + ivec3(floor((middle - cube.xyz) * cube.w));
    return LastPlace(clamp(last, first, first + frame.gridSide - 1), cascade == own);
}

// The cell in the index of the last pose, or in that of the static geometry.
uint lastCellAt(ivec3 voxel) {
    return list == 0u ? staticCellAt(voxel) : cellInPages(previousIndex, previousPages, voxel);
}

// The id of a cell's face, counted from 1, or 0 if it has none that has been lit.
uint litFace(uint cell, int face) {
    if (!hasFace(cell, face)) return 0u;
    uint id = faceId(cell, face);
    if (VCT_CASCADES > 1 && id < commands[0].faceCapacity && isFresh(id)) return 0u;
    bool isLit =
        cachedHit(id, 0u) != VCT_HIT_UNKNOWN || faceIrradianceData[irradianceAt(id) + VCT_MEAN_SHOWN] != 0u;
    return isLit ? id + 1u : 0u;
}

void main() {
    bool isStatic = list == 0u;
    uint count = faceCount(isStatic ? uint(VCT_LIST_VISITED) : list);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint n = gl_GlobalInvocationID.x; n < count; n += stride) {
        uint i = isStatic ? faceData[commands[VCT_LIST_VISITED].firstFace + n] : n;
        ListedFace listed = listedFace(list, i);
        uint id = commands[list].firstId + i;
        LastPlace last = lastPlaceOf(listed.voxel);
        uint from = litFace(lastCellAt(last.voxel), listed.face);
        bool isSame = !isStatic && from != 0u && last.isSame;
        for (int n = 0; n < 27 && from == 0u; ++n) {
            ivec3 beside = last.voxel + ivec3(n % 3, n / 3 % 3, n / 9) - 1;
            if (beside != clampToCascade(beside, last.voxel, frame.gridSide)) continue;
            from = litFace(lastCellAt(beside), listed.face);
            if (from == 0u && list == dynamicList) from = litFace(staticCellAt(beside), listed.face);
        }
        // Direct light of a moving object changes. Means that this light step computes before it reads them
        // keep what the words had.
        uint to = irradianceAt(id), old = irradianceAt(max(from, 1u) - 1u);
        for (uint word = VCT_MEAN_SMOOTH; word < VCT_MEAN_GAIN; ++word) {
            uint value = faceIrradianceData[old + word];
            bool isKept = isSame || from != 0u && word < VCT_MEAN_REFINED;
            faceIrradianceData[to + word] = isKept ? value : 0u;
        }
        for (uint word = VCT_MEAN_SKY; word < VCT_FACE_SIGHT; ++word) {
            uint value = faceIrradianceData[old + word];
            faceIrradianceData[to + word] = from != 0u && !isStatic ? value : 0u;
        }
        // The rays of a new static face are unknown, but those of the coarser one tell how near surfaces are.
        uint sight = faceIrradianceData[old + VCT_FACE_SIGHT];
        faceIrradianceData[to + VCT_FACE_SIGHT] = from == 0u ? 0u : isStatic ? sight & 0xFFFFu : sight;
        for (uint word = VCT_FACE_BLOCKED + 1u; word < VCT_IRRADIANCE_WORDS; ++word)
            faceIrradianceData[to + word] = 0u;
#ifdef VCT_EMITTERS
        if (from != 0u) takeEmitterIrradiance(id, from - 1u);
#endif
        if (isSame) faceIrradianceData[forwardAt(from - 1u)] = id + 1u;
        if (isStatic) {
#if VCT_CASCADES > 1
            storeChangedNow(id);
#endif
            for (uint quad = 0u; quad < uint(VCT_DIRECTIONS) / 4u; ++quad)
                storeCachedHits(id, quad, uvec4(VCT_HIT_UNKNOWN));
        } else {
            faceIrradianceData[forwardAt(id)] = 0u;
        }
        faceData[radianceAt(id)] = from != 0u ? faceData[radianceAt(from - 1u)] : 0u;
        // carry_hits.comp finds the face whose hits it copies in place of the first hit.
        if (!isStatic) storeCachedHit(id, 0u, from);
    }
}
