// What each face of the base level receives of the compact emitters: a cone towards each of their parts. What share of the
// hemisphere the part fills has a closed form, and the cone finds how much of that is hidden ("next event estimation"). The
// result depends only on where things are; it is renewed for a quarter of the faces in each step after something moved,
// and for new faces at once.
#include "directional/face_sums.glsl"
#include "directional/cones.glsl"
#include "directional/face_irradiance.glsl"
#include "shared/emitters.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// A cone's width over the part's own: a cone as wide as the part would meet what is beside it.
const float coneWidth = 0.25;
// Halves hold nothing below it.
const float smallestLight = 6e-8;

// A cone's transmittance at `reach`; `tangent` is that of its half angle. Lengths in voxels.
mediump float transmittanceTo(Cone cone, float reach, float tangent) {
    ConeResult result = coneBegin;
    while (result.distance < reach) {
        COUNT(VCT_COUNTER_EMITTERS_STEP);
        // No wider than the rest of the way either: else it would meet the emitter.
        float widest = min(VCT_GATHER_HEIGHT * heightAt(cone, result.distance), 0.5 * (reach - result.distance));
        float level = floor(log2(max(min(2.0 * result.distance * tangent, widest), 1.0)));
        // The last sample reaches beyond the end.
        mediump float within = min((reach - result.distance) / (VCT_GATHER_STEP * exp2(level)), 1.0);
        if (takeSample(result, cone, level, 0.0, within * sampleOpacity)) break;
    }
    return coneEnd(result).transmittance;
}

// Relative to E/pi.
vec3 lightOfEmitters(vec3 start, SurfacePlane plane, vec3 ownBelow) {
    float grid = float(frame.gridSide);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < emitters.count.x; ++i) {
        EmitterPartUniforms part = emitters.part[i];
        vec3 offset = part.position.xyz - start / grid;
        float distance = max(length(offset), 1e-6);
        vec3 towards = offset / distance;
        float area = projectedArea(part, towards);
        // Form factor of a small disc (near to it, of one that faces the surface).
        float share = max(dot(towards, plane.normal), 0.0) * area / (3.1415927 * distance * distance + area);
        vec3 light = part.radiance.rgb * share;
        if (max(light.r, max(light.g, light.b)) < smallestLight) continue;
        COUNT(VCT_COUNTER_EMITTERS_CONE);
        // Along a flat part its own voxels, and those of what it hangs on, are near for longer.
        float rising = clamp(area / (length(part.facing.xyz) + part.facing.w), 0.25, 1.0);
        float reach = (distance - part.radiance.w / rising) * grid;
        Cone cone = coneFrom(start, plane.normal, ownBelow, towards, false);
        sum += light * transmittanceTo(cone, reach, coneWidth * part.position.w / distance);
    }
    return sum;
}

// Whether a face's turn has come: new faces at once, and a quarter of the others in each step, whole work groups of them.
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
        vec3 start = vec3(listed.voxel) + 0.5 + plane.normal * (plane.offset + VCT_GATHER_START);
        storeEmitterIrradiance(id, lightOfEmitters(start, plane, ownFaces(plane.normal, surface.hasBack)));
    }
}
