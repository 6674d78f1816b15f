// Irradiance of the base level's faces by the compact emitters. It depends on geometry only. After something
// has moved, a quarter of the faces is updated in each step, and new faces at once. If only cascades have
// moved, the active faces are updated.
#include "directional/active_faces.glsl"
#define VCT_RAY_STEP VCT_COUNTER_EMITTERS_STEP
#define VCT_RAY_FACE VCT_COUNTER_EMITTERS_VOXEL_FACE
#define VCT_RAY_LIMIT VCT_COUNTER_EMITTERS_LIMIT
#define VCT_EMITTER_RAY VCT_COUNTER_EMITTERS_RAY
#include "directional/emitter_light.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_ALL) uniform bool visitsAll;  // false: only active faces are updated

// Irradiance by all emitters, relative to E, at a point above a surface, in voxels. `other`: the face's
// irradiance by other surfaces and the sky. An emitter that would add less than half a percent to it costs no
// ray.
vec3 lightOfEmitters(vec3 start, int cascade, vec3 normal, vec3 other) {
    float negligible = 0.005 * max(other.r, max(other.g, other.b));
    vec3 position = volumeFromVoxels(start, cascade), sum = vec3(0.0);
    for (int i = 0; i < emitters.count.x; ++i) {
        EmitterPartUniforms part = emitters.part[i];
        SeenPart seen = seenPart(part, position, normal);
        if (!isStorable(seen.light) || max(seen.light.r, max(seen.light.g, seen.light.b)) < negligible)
            continue;
        sum += lightOfPart(part, seen, start, cascade);
    }
    return sum;
}

// True if a face is to be updated: a new face, or one in the share of the blocks that have their turn. The
// turn must not depend on the order of the list, because light that is negligible in one step may not be so
// in another.
bool isDue(uint id, ivec3 voxel) {
    float history = historyLength(id);
    if (!visitsAll) return history < lightStep.longEnough;
    ivec3 block = voxel >> VCT_BRICK_LEVEL;
    return history == 0.0 || (uint(block.x + block.y + block.z) + lightStep.frame) % VCT_TURN_PERIOD == 0u;
}

void main() {
    COUNT(VCT_COUNTER_EMITTERS);
    uint count = visitedFaceCount(visitsAll);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(visitsAll, i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged || !isDue(id, listed.voxel)) continue;
        COUNT(VCT_COUNTER_EMITTERS_FACE);
        SurfacePlane plane = facePlane(id);
        vec3 start =
            surfaceMiddle(listed.voxel, listed.face, plane, faceExtent(id)) + startHeight * plane.normal;
        storeEmitterIrradiance(id, lightOfEmitters(start, cascadeOf(listed.voxel), plane.normal,
                                                   faceIrradianceAt(id).light.rgb));
    }
}
