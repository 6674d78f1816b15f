// What each face of the base level receives of the lamps: it looks at each of their parts by a cone of its own. In
// closed form is what share of the hemisphere the part is, the cone finds how much of that is hidden ("next event
// estimation"). It depends on nothing but where things are, and is found anew for a quarter of the faces in each step after
// something moved, and for new faces at once.
#define VCT_CONE_COUNTER VCT_COUNTER_EMITTERS_STEP
#include "shared/counters.glsl"
#include "directional/face_list.glsl"
#include "directional/cones.glsl"
#include "directional/received.glsl"
#include "shared/emitters.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D index;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

// Of the part's own width: a cone as wide as the part would meet what is beside it.
const float coneWidth = 0.25;

// What is left of a cone's light at `reach`; its half angle has that tangent. Lengths in voxels.
mediump float transmittanceTo(vec3 start, vec3 normal, vec3 ownBelow, vec3 direction, float reach, float tangent) {
    float grid = float(frame.gridSide);
    mediump float transmittance = 1.0;
    float distance = VCT_GATHER_FIRST_SAMPLE;
    float rise = dot(direction, normal);
    while (distance < reach) {
        COUNT(VCT_CONE_COUNTER);
        float height = VCT_GATHER_START + distance * rise;
        // No wider than what is left either: else it would meet the lamp.
        float widest = min(VCT_GATHER_HEIGHT * height, 0.5 * (reach - distance));
        float footprint = max(min(2.0 * distance * tangent, widest), 1.0);
        float level = floor(log2(footprint));
        bvec3 own = lessThan(direction * normal, height < VCT_GATHER_OWN_SURFACE * exp2(level) ? ownBelow : vec3(-1.0));
        mediump vec3 share = mix(abs(direction), vec3(0.0), own);
        mediump float met = sampleFaces((start + direction * distance) / grid, direction, share, level).a;
        // The last sample reaches beyond the end.
        float stride = VCT_GATHER_STEP * exp2(level);
        mediump float within = min((reach - distance) / stride, 1.0);
        transmittance = transmittance - within * sampleOpacity * min(met, 1.0);
        if (transmittance < VCT_GATHER_THRESHOLD) return 0.0;
        distance += stride;
    }
    return transmittance;
}

// Relative to E/pi over frame.radianceRange.
vec3 lightOfEmitters(vec3 start, SurfacePlane plane, vec3 ownBelow) {
    float grid = float(frame.gridSide);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < emitters.count.x; ++i) {
        EmitterPartUniforms part = emitters.part[i];
        vec3 offset = part.place.xyz - start / grid;
        float distance = max(length(offset), 1e-6);
        vec3 towards = offset / distance;
        float area = seenArea(part, towards);
        // Form factor of a small disc (near to it, of one that faces the surface).
        float share = max(dot(towards, plane.normal), 0.0) * area / (3.1415927 * distance * distance + area);
        vec3 light = part.radiance.rgb * (share / frame.radianceRange);
        if (max(light.r, max(light.g, light.b)) < 1e-5) continue;
        COUNT(VCT_COUNTER_EMITTERS_CONE);
        // Along a flat part its own voxels, and those of what it hangs on, are near for longer.
        float rising = clamp(area / (length(part.facing.xyz) + part.facing.w), 0.25, 1.0);
        float reach = (distance - part.radiance.w / rising) * grid;
        sum += light * transmittanceTo(start, plane.normal, ownBelow, towards, reach, coneWidth * part.place.w / distance);
    }
    return sum;
}

void lookAt(uint i) {
    COUNT(VCT_COUNTER_EMITTERS_FACE);
    ListedFace listed = listedFace(level, i);
    uint slot = texelFetch(index, listed.voxel, 0).r - 1u;
    if (slot >= voxelPlaces()) return;
    SurfacePlane plane = facePlane(slot, listed.face);
    vec3 start = vec3(listed.voxel) + 0.5 + plane.normal * (plane.offset + VCT_GATHER_START);
    vec3 light = lightOfEmitters(start, plane, ownFaces(plane.normal, hasBack(slot, listed.face, plane)));
    storeFromEmitters(i, light);
    // What it inherited was all light together (directional/light_inherit.comp).
    if (i < lightStep.firstNew || stepsOf(i) == 0.0) return;
    Received mean = receivedOf(i);
    mean.light = max(mean.light - light, 0.0);
    mean.atStart = mean.light;
    storeReceived(i, mean);
}

void main() {
    COUNT(VCT_COUNTER_EMITTERS);
    uint count = faceCount(level), old = min(lightStep.firstNew, count);
    uint first = lightStep.frame & 3u, quarter = (old + 3u - first) / 4u;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < quarter + count - old; i += stride)
        lookAt(i < quarter ? 4u * i + first : old + i - quarter);
}
