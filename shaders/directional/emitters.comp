// Irradiance of the base level's faces by the compact emitters. It depends on geometry only. After something
// has moved, a quarter of the faces is updated in each step, and new faces at once. If only cascades have
// moved, the active faces are updated.
#include "directional/face_sums.glsl"
#include "directional/cones.glsl"
#include "directional/active_faces.glsl"
#define VCT_COUNTER_CONTACT_VOXEL VCT_COUNTER_EMITTERS_VOXEL
#define VCT_COUNTER_CONTACT_FACE VCT_COUNTER_EMITTERS_OTHER_FACE
#include "directional/contact.glsl"
#include "directional/emitter_light.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_ALL) uniform bool visitsAll;  // false: only active faces are updated

// Irradiance by all emitters, relative to E. `other`: the face's irradiance by other surfaces and the sky.
// An emitter that would add less than half a percent to it costs no cone.
vec3 lightOfEmitters(ConeStart start, SurfacePlane plane, vec3 ownBelow, vec3 other) {
    float negligible = 0.005 * max(other.r, max(other.g, other.b));
    int cascade = cascadeOf(start.voxel);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < emitters.count.x; ++i) {
        EmitterPartUniforms part = emitters.part[i];
        SeenPart seen = seenPart(part, volumeFromVoxels(start.position, cascade), plane.normal);
        if (!isStorable(seen.light) || max(seen.light.r, max(seen.light.g, seen.light.b)) < negligible)
            continue;
        float toOpposite = distanceToOpposite(start, seen.towards);
        if (toOpposite >= 0.0 && toOpposite < (seen.distance - endOfCones(part)) * voxelsAlongVolume(cascade))
            continue;
        COUNT(VCT_COUNTER_EMITTERS_CONE);
        sum += lightOfPart(part, seen, start.position, cascade, plane.normal, ownBelow);
    }
    return sum;
}

// True if a face is to be updated: a new face, or one in the share of the work groups that have their turn.
bool isDue(uint id, uint i) {
    float history = historyLength(id);
    if (!visitsAll) return history < lightStep.longEnough;
    return history == 0.0 || (i / uint(VCT_LIST_GROUP) + lightStep.frame) % VCT_TURN_PERIOD == 0u;
}

void main() {
    COUNT(VCT_COUNTER_EMITTERS);
    uint count = visitedFaceCount(visitsAll);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(visitsAll, i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged || !isDue(id, i)) continue;
        COUNT(VCT_COUNTER_EMITTERS_FACE);
        FaceSurface surface = faceSurface(id);
        SurfacePlane plane = surface.plane;
        ConeStart start = coneStartOf(listed.voxel, listed.face, plane);
        vec3 ownBelow = ownFaces(plane.normal, surface.hasBack);
        storeEmitterIrradiance(id, lightOfEmitters(start, plane, ownBelow, faceIrradianceAt(id).light));
    }
}
