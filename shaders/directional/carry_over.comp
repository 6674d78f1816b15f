// Gives the faces of dynamic objects in a new pose a history: that of the same face in the last pose, or else
// the mean of a neighbouring voxel's faces, dynamic in the last pose or static.
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_PREVIOUS_VOXELS) uniform highp usampler3D previousIndex;

struct History {
    FaceIrradiance mean;
    vec3 emitterLight;
    float weight;
};

void add(inout History history, uint cell, int face, uint firstId, uint endId) {
    if (!hasFace(cell, face)) return;
    uint id = faceId(cell, face, firstId);
    if (id >= endId) return;
    FaceIrradiance mean = faceIrradianceAt(id);
    if (mean.steps == 0.0) return;
    history.mean.light += mean.light;
    history.mean.roundStart += mean.roundStart;
    history.mean.nearness += mean.nearness;
    history.mean.steps += min(mean.steps, lightStep.maxInheritedHistory);
    history.emitterLight += emitterIrradiance(id);
    history.weight += 1.0;
}

void main() {
    COUNT(VCT_COUNTER_CARRY_OVER);
    uint count = faceCount(dynamicList), previous = dynamicList ^ 1u;
    uint firstId = commands[previous].firstId, endId = firstId + faceCount(previous);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_CARRY_OVER_FACE);
        ListedFace listed = listedFace(dynamicList, i);
        History history = History(FaceIrradiance(vec3(0.0), 0.0, vec3(0.0), 0.0), vec3(0.0), 0.0);
        add(history, texelFetch(previousIndex, listed.voxel, 0).r, listed.face, firstId, endId);
        for (int n = 0; n < 27 && history.weight < 1.0; ++n) {
            COUNT(VCT_COUNTER_CARRY_OVER_NEIGHBOUR);
            ivec3 beside = listed.voxel + ivec3(n % 3, n / 3 % 3, n / 9) - 1;
            if (beside != clamp(beside, ivec3(0), textureSize(staticIndex, 0) - 1)) continue;
            add(history, texelFetch(previousIndex, beside, 0).r, listed.face, firstId, endId);
            add(history, texelFetch(staticIndex, beside, 0).r, listed.face, 0u, faceCount(0u));
        }
        float share = 1.0 / max(history.weight, 1.0);
        FaceIrradiance mean = history.mean;
        uint id = commands[dynamicList].firstId + i;
        storeFaceIrradiance(id, FaceIrradiance(mean.light * share, mean.steps * share,
                                               mean.roundStart * share, mean.nearness * share));
        storeEmitterIrradiance(id, history.emitterLight * share);
    }
}
