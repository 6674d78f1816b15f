// Gives the faces of dynamic objects in a new pose a history: that of the same face in the last pose, or else
// the mean of a neighbouring voxel's faces, dynamic in the last pose or static. If cascades have moved with
// the camera, static faces come first, and a face that the same cascade did not hold takes over the history
// of a coarser one. A face that it did hold also keeps its radiance.
#include "directional/cascades.glsl"
#include "directional/face_sums.glsl"
#include "directional/voxels.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_PREVIOUS_VOXELS) uniform highp usampler3D previousIndex;
layout(location = VCT_UNIFORM_LIST) uniform uint list;

struct History {
    FaceIrradiance mean;
    vec3 emitterLight;
    float weight;
};

void add(inout History history, uint cell, int face) {
    if (!hasFace(cell, face)) return;
    uint id = faceId(cell, face);
    FaceIrradiance mean = faceIrradianceAt(id);
    if (mean.steps == 0.0) return;
    history.mean.light += mean.light;
    history.mean.roundStart += mean.roundStart;
    history.mean.nearness += mean.nearness;
    history.mean.steps += min(mean.steps, lightStep.maxInheritedHistory);
    history.emitterLight += emitterIrradiance(id);
    history.weight += 1.0;
}

// The voxel's place before the cascades moved, in its own cascade or in a coarser one.
struct LastPlace {
    ivec3 voxel;
    bool isSame;  // in its own cascade
};
LastPlace lastPlaceOf(ivec3 voxel) {
    if (cascades == 1) return LastPlace(voxel, true);
    int own = cascadeOf(voxel), cascade = own;
    vec3 middle = volumeFromVoxels(vec3(voxel) + 0.5, own);
    while (cascade < cascades - 1 && voxelsInside(middle, frame.lastCascade[cascade]) <= 0.0)
        ++cascade;
    vec4 cube = frame.lastCascade[cascade];
    ivec3 first = ivec3(0, 0, cascade * frame.gridSide);
    ivec3 last = first + ivec3(floor((middle - cube.xyz) * cube.w));
    return LastPlace(clamp(last, first, first + frame.gridSide - 1), cascade == own);
}

// Gives a static face of a cascade that has moved in this frame the radiance that it had at its last place.
// The injection skips it then.
void restoreRadiance(ListedFace listed, uint id, LastPlace last, uint lastCell) {
    if (list != staticList || !last.isSame || !hasFace(lastCell, listed.face)) return;
    faceData[faceAt(id) + VCT_FACE_RADIANCE] =
        faceData[faceAt(faceId(lastCell, listed.face)) + VCT_FACE_RADIANCE];
}

// The history of a coarser cascade's face has the wrong detail, so new light soon replaces it.
const float maxStepsFromCoarser = 8.0;

void main() {
    COUNT(VCT_COUNTER_CARRY_OVER);
    uint count = faceCount(list);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_CARRY_OVER_FACE);
        ListedFace listed = listedFace(list, i);
        History history = History(FaceIrradiance(vec4(0.0), 0.0, vec4(0.0), 0.0), vec3(0.0), 0.0);
        LastPlace last = lastPlaceOf(listed.voxel);
        uint lastCell = texelFetch(previousIndex, last.voxel, 0).r;
        add(history, lastCell, listed.face);
        if (VCT_CASCADES > 1) restoreRadiance(listed, commands[list].firstId + i, last, lastCell);
        for (int n = 0; n < 27 && history.weight < 1.0; ++n) {
            COUNT(VCT_COUNTER_CARRY_OVER_NEIGHBOUR);
            ivec3 beside = last.voxel + ivec3(n % 3, n / 3 % 3, n / 9) - 1;
            if (beside != clampToCascade(beside, last.voxel, frame.gridSide)) continue;
            add(history, texelFetch(previousIndex, beside, 0).r, listed.face);
            if (list == dynamicList) add(history, texelFetch(staticIndex, beside, 0).r, listed.face);
        }
        float share = 1.0 / max(history.weight, 1.0);
        FaceIrradiance mean = history.mean;
        uint id = commands[list].firstId + i;
        float steps = min(mean.steps * share, last.isSame ? 1e4 : maxStepsFromCoarser);
        storeFaceIrradiance(
            id, FaceIrradiance(mean.light * share, steps, mean.roundStart * share, mean.nearness * share));
        storeEmitterIrradiance(id, history.emitterLight * share);
    }
}
