// Irradiance of the base level's faces by the compact emitters. A closed form gives the share of the
// hemisphere that a part of an emitter fills, and a cone towards the part gives its visibility (next event
// estimation). The result depends on geometry only. After something has moved, a quarter of the faces is
// updated in each step, and new faces at once.
#include "directional/face_sums.glsl"
#include "directional/cones.glsl"
#include "directional/face_irradiance.glsl"
#define VCT_COUNTER_CONTACT_VOXEL VCT_COUNTER_EMITTERS_VOXEL
#define VCT_COUNTER_CONTACT_FACE VCT_COUNTER_EMITTERS_OTHER_FACE
#include "directional/contact.glsl"
#include "shared/emitters.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// Width of a cone relative to its part. A cone as wide as the part would meet surfaces beside it.
const float coneWidth = 0.25;
// The smallest positive half float.
const float minStoredLight = 6e-8;

// A cone's transmittance at the distance `reach`, in voxels. `tangent`: tangent of its half angle.
mediump float transmittanceTo(Cone cone, float reach, float tangent) {
    ConeResult result = coneBegin;
    while (result.distance < reach) {
        COUNT(VCT_COUNTER_EMITTERS_STEP);
        // Samples narrow again towards the emitter, so that they do not meet it.
        float widest =
            min(VCT_GATHER_HEIGHT * heightAt(cone, result.distance), 0.5 * (reach - result.distance));
        float level = floor(log2(max(min(2.0 * result.distance * tangent, widest), 1.0)));
        // The last sample counts in proportion to its part before the end.
        mediump float within = min((reach - result.distance) / (VCT_GATHER_STEP * exp2(level)), 1.0);
        if (addSample(result, cone, level, within * sampleOpacity)) break;
    }
    return coneEnd(result).transmittance;
}

// Irradiance by all emitters, relative to E.
vec3 lightOfEmitters(ConeStart start, SurfacePlane plane, vec3 ownBelow) {
    int cascade = cascadeOf(start.voxel);
    float grid = voxelsAlongVolume(cascade);
    vec3 position = volumeFromVoxels(start.position, cascade);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < emitters.count.x; ++i) {
        EmitterPartUniforms part = emitters.part[i];
        vec3 offset = part.position.xyz - position;
        float distance = max(length(offset), 1e-6);
        vec3 towards = offset / distance;
        float area = projectedArea(part, towards);
        // Form factor of a small disc. Close to it, the area in the denominator keeps the factor below 1, as
        // for a disc that faces the surface.
        float share = max(dot(towards, plane.normal), 0.0) * area / (3.1415927 * distance * distance + area);
        vec3 light = part.radiance.rgb * share;
        if (max(light.r, max(light.g, light.b)) < minStoredLight) continue;
        float toOpposite = distanceToOpposite(start, towards);
        float end = endOfCones(part);
        if (toOpposite >= 0.0 && toOpposite < (distance - end) * grid) continue;
        COUNT(VCT_COUNTER_EMITTERS_CONE);
        // A cone at a grazing angle to a flat part is near its voxels, and its support's, for longer.
        float rising = clamp(area / (length(part.facing.xyz) + part.facing.w), 0.25, 1.0);
        float reach = (distance - end / rising) * grid;
        Cone cone = coneFrom(start.position, cascade, plane.normal, ownBelow, towards, false);
        sum += light * transmittanceTo(cone, reach, coneWidth * part.position.w / distance);
    }
    return sum;
}

// True if a face is to be updated: a new face, or one in the quarter of the work groups that have their turn.
bool isDue(uint id, uint i) {
    return historyLength(id) == 0.0 || (i / uint(VCT_LIST_GROUP) + lightStep.frame) % 4u == 0u;
}

void main() {
    COUNT(VCT_COUNTER_EMITTERS);
    uint count = baseFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = baseFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged || !isDue(id, i)) continue;
        COUNT(VCT_COUNTER_EMITTERS_FACE);
        FaceSurface surface = faceSurface(id);
        SurfacePlane plane = surface.plane;
        ConeStart start = coneStartOf(listed.voxel, listed.face, plane);
        storeEmitterIrradiance(id, lightOfEmitters(start, plane, ownFaces(plane.normal, surface.hasBack)));
    }
}
