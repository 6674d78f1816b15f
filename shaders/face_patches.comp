// Before the bounces: where the surface of each patch is, and where it looks. VCT_RELIGHT: that is there, and the sums
// of its coverage and albedo too; only its light is new.
#include "shared/trips.glsl"
#include "shared/face_list.glsl"
#include "shared/face_patches.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_FACES) uniform mediump sampler3D faces;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D slots;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // of the patches

vec4 faceAt(ivec3 voxel, int axis, int side, int lod) {
    return texelFetch(faces, faceTexel(voxel, axis, side, frame.grid.x >> lod), lod);
}

void main() {
    TRIP(VCT_TRIPS_FACE_PATCHES);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    if (gl_GlobalInvocationID.x < VCT_PATCH_ENERGIES) facePatches[gl_GlobalInvocationID.x] = 0u;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_FACE_PATCHES_PATCH);
        ListedFace listed = listedFace(level, i);
        uint occupied = texelFetch(slots, listed.voxel, int(level)).r;
        if ((occupied >> VCT_FACE_MASK_BITS) >= patchPlaces()) continue;
        uint patchAt = patchIndex(occupied, listed.face);
        int axis = listed.face >> 1, side = listed.face & 1;
        vec4 face = faceAt(listed.voxel, axis, side, int(level));
#ifndef VCT_RELIGHT
        // The mean normal of what looks this way: from the other axes, what one side covers more than the other.
        vec3 normal;
        for (int other = 0; other < 3; ++other)
            normal[other] = other == axis ? (side == 0 ? 1.0 : -1.0) * max(face.a, 1.0 / 255.0)
                                          : faceAt(listed.voxel, other, 0, int(level)).a -
                                                faceAt(listed.voxel, other, 1, int(level)).a;
        vec4 middle = vec4(vec3(0.5e-4), 1e-4);  // the block's, where nothing is left of the coverage
        for (int child = 0; child < 8; ++child) {
            ivec3 place = ivec3(child & 1, (child >> 1) & 1, child >> 2);
            middle += faceAt(listed.voxel * 2 + place, axis, side, int(level) - 1).a * vec4(vec3(place) * 0.5 + 0.25, 1.0);
        }
        facePatches[patchAt + VCT_PATCH_MIDDLE] = packSteps(middle.xyz / middle.w);
        facePatches[patchAt + VCT_PATCH_NORMAL] = packSteps(normalize(normal) * 0.5 + 0.5);
        for (uint word = VCT_PATCH_COVERAGE; word < VCT_PATCH_LIGHT; ++word)
            facePatches[patchAt + word] = 0u;
#endif
        facePatches[patchAt + VCT_PATCH_DIRECT] = packUnorm4x8(face);
        for (uint word = VCT_PATCH_LIGHT; word < VCT_PATCH_WORDS; ++word)
            facePatches[patchAt + word] = 0u;
    }
}
