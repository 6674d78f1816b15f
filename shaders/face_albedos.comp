// Before the bounces: every face of the base level adds its albedo to its patch.
#include "shared/trips.glsl"
#include "shared/face_list.glsl"
#include "shared/face_patches.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D slots;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    TRIP(VCT_TRIPS_FACE_ALBEDOS);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_FACE_ALBEDOS_FACE);
        ListedFace listed = listedFace(level, i);
        uint occupied = texelFetch(slots, listed.voxel >> VCT_PATCH_LEVEL, VCT_PATCH_LEVEL).r;
        if ((occupied >> VCT_FACE_MASK_BITS) >= patchPlaces()) continue;
        FaceSum sum = faceSum(texelFetch(slots, listed.voxel, 0).r - 1u, listed.face);
        uvec4 steps = uvec4(vec4(sum.coverage, sum.albedo) * VCT_PATCH_UNITS + 0.5);
        uint patchAt = patchIndex(occupied, listed.face);
        atomicAdd(facePatches[patchAt + VCT_PATCH_COVERAGE], steps.x);
        for (int c = 0; c < 3; ++c)
            atomicAdd(facePatches[patchAt + VCT_PATCH_ALBEDO + uint(c)], steps[c + 1]);
    }
}
