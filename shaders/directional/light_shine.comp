// Every face of the base level shines with its own light, and with its albedo's share of what it received.
#include "shared/counters.glsl"
#include "directional/face_list.glsl"
#include "directional/voxels.glsl"
#include "directional/received.glsl"
#include "directional/sky_light.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D index;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

shared uint groupSums[9];

// Whole numbers before they are added: then their order does not matter.
uvec3 inUnits(vec3 value) {
    return uvec3(value * lightStep.sumUnits + 0.5);
}

void add(uint first, uvec3 value) {
    for (uint c = 0u; c < 3u; ++c)
        atomicAdd(groupSums[first + c], value[c]);
}

vec3 sumOf(uint sums) {
    return vec3(received[sums], received[sums + 1u], received[sums + 2u]);
}

// Light that goes round in a closed room comes to its balance slowly: each step adds one bounce, and the mean delays it.
// So all that was received is scaled by what the last step's sums say. Of all light that faces send, those sums give the
// share k that other faces receive; in balance the received light is k (direct + reflected) + sky, and a factor s on what
// was received before solves that for all faces together, as a coarse grid of one cell does in a multigrid solver. The
// mean of that step has moved by its own share already; here it comes as near to the balance as `towardsBalance` says: half
// the way while the light is found, and in rounds no more than the mean does, as the directions of one step favour some light.
vec3 towardsBalance() {
    uint sums = lightSums(lightStep.frame + 2u);  // of the step before
    vec3 before = sumOf(sums + VCT_SUM_BEFORE);
    vec3 fromFaces = sumOf(sums + VCT_SUM_RECEIVED);
    vec3 reflected = sumOf(sums + VCT_SUM_REFLECTED);
    vec3 direct = sumOf(sums + VCT_SUM_DIRECT);
    vec3 sky = skyLight(skySum(sums + VCT_SUM_SKY));
    vec3 share = fromFaces / max(direct + reflected, 1.0);
    // A room where nothing is absorbed would have no bound.
    vec3 left = max(before - share * reflected, (1.0 - frame.largestBounceShare) * before);
    vec3 balance = clamp((share * direct + sky) / max(left, 1.0), 0.25, 4.0);
    vec3 found = clamp((fromFaces + sky) / max(before, 1.0), 0.25, 4.0);
    vec3 factor = (1.0 + lightStep.towardsBalance * (balance - 1.0)) / (1.0 + lightStep.amplitude * (found - 1.0));
    return mix(vec3(1.0), clamp(factor, 0.5, 4.0), greaterThan(before, vec3(64.0)));
}

void main() {
    COUNT(VCT_COUNTER_LIGHT_SHINE);
    if (gl_LocalInvocationIndex < 9u) groupSums[gl_LocalInvocationIndex] = 0u;
    if (gl_GlobalInvocationID.x < VCT_LIGHT_SUMS) received[lightSums(lightStep.frame + 1u) + gl_GlobalInvocationID.x] = 0u;
    barrier();
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    uvec3 before = uvec3(0u), reflected = uvec3(0u), direct = uvec3(0u);
    vec3 factor = lightStep.amplitude > 0.0 ? towardsBalance() : vec3(1.0);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_LIGHT_SHINE_FACE);
        ListedFace listed = listedFace(level, i);
        uint slot = texelFetch(index, listed.voxel, 0).r - 1u;
        if (slot >= voxelPlaces()) continue;
        Received mean = receivedOf(i);
        mean.light = min(mean.light * factor, 1.0);
        mean.atStart = min(mean.atStart * factor, 1.0);
        storeReceived(i, mean);
        FaceSum sum = faceSum(slot, listed.face);
        before += inUnits(sum.coverage * mean.light);
        vec3 reflecting = lightStep.reflected * sum.albedo;
        reflected += inUnits(reflecting * mean.light);
        vec3 own = sum.radiance + reflecting * fromEmitters(i);
        direct += inUnits(min(own, 1.0));
        vec3 radiance = own + reflecting * mean.light;
        ivec3 texel = faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, frame.gridSide);
        imageStore(faces, texel, storedFace(vec4(radiance, sum.coverage), texel, lightStep.frame));
    }
    add(VCT_SUM_BEFORE, before);
    add(VCT_SUM_REFLECTED, reflected);
    add(VCT_SUM_DIRECT, direct);
    barrier();
    if (gl_LocalInvocationIndex < 9u)
        atomicAdd(received[lightSums(lightStep.frame) + gl_LocalInvocationIndex], groupSums[gl_LocalInvocationIndex]);
}
