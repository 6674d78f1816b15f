// One more bounce, first half: what every patch receives, by a few cones from the middle of its surface.
#define VCT_CONE_TRIPS VCT_TRIPS_BOUNCE_GATHER_STEP
#include "shared/trips.glsl"
#include "shared/face_list.glsl"
#include "shared/face_cones.glsl"
#include "shared/face_patches.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D slots;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // of the patches: VCT_GATHER_FINEST_LEVEL
layout(location = VCT_UNIFORM_BOUNCE) uniform uint bounce;

vec3 received(ivec3 block, uint patchAt) {
    vec3 middle = unpackSteps(facePatches[patchAt + VCT_PATCH_MIDDLE]);
    vec3 normal = normalize(unpackSteps(facePatches[patchAt + VCT_PATCH_NORMAL]) - 0.5);
    // A quarter of the block more than from a pixel: the surface may lie anywhere in it.
    vec3 start = (vec3(block) + middle) * finestFootprint + normal * (VCT_GATHER_START + 0.25 * finestFootprint);
    mat3 volumeFromCone = frameAround(normal);
    int rotation = (block.x * 5 + block.y * 3 + block.z * 7) & 15;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < VCT_GATHER_CONES; ++i) {
        TRIP(VCT_TRIPS_BOUNCE_GATHER_CONE);
        vec3 cone = gatherCone(i, rotation);
        ConeResult result =
            traceCone(start, normal, volumeFromCone * cone, 2.0 * float(frame.grid.x));
        sum += result.radiance + result.transmittance * frame.skyRadiance.rgb;
    }
    return sum / float(VCT_GATHER_CONES);
}

void main() {
    TRIP(VCT_TRIPS_BOUNCE_GATHER);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    if (gl_GlobalInvocationID.x < 3u) facePatches[bounceEnergy(bounce + 1u) + gl_GlobalInvocationID.x] = 0u;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_BOUNCE_GATHER_PATCH);
        ListedFace listed = listedFace(level, i);
        uint occupied = texelFetch(slots, listed.voxel, int(level)).r;
        if ((occupied >> VCT_FACE_MASK_BITS) >= patchPlaces()) continue;
        uint patchAt = patchIndex(occupied, listed.face);
        vec3 light = received(listed.voxel, patchAt);
        vec3 before = patchLight(patchAt + VCT_PATCH_LIGHT);
        storePatchLight(patchAt + VCT_PATCH_LIGHT, light);
        storePatchLight(patchAt + VCT_PATCH_BEFORE, before);
        float coverage = unpackUnorm4x8(facePatches[patchAt + VCT_PATCH_DIRECT]).a;
        vec3 added = coverage * patchAlbedo(patchAt) * (light - before) / frame.faces.y;
        ivec3 units = ivec3(round(clamp(added, -1.0, 1.0) * VCT_ENERGY_UNITS));
        for (int c = 0; c < 3; ++c)
            atomicAdd(facePatches[bounceEnergy(bounce) + uint(c)], uint(units[c]));
    }
}
