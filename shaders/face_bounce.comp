// After the last bounce: every face of the base level shines with its direct light, with what its patch received, and
// with what more bounces would bring.
#include "shared/trips.glsl"
#include "shared/face_list.glsl"
#include "shared/face_patches.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D slots;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0
layout(location = VCT_UNIFORM_BOUNCE) uniform uint bounce;

vec3 energyOf(uint whichBounce) {
    uint index = bounceEnergy(whichBounce);
    return vec3(ivec3(uvec3(facePatches[index], facePatches[index + 1u], facePatches[index + 2u])));
}

// Each bounce adds about the same share of what the one before it added: by how much of the last one's the rest of this
// geometric series exceeds it. The share is that of the whole scene, and no more than the largest albedo.
vec3 tail() {
    if (bounce < 2u) return vec3(0.0);
    vec3 ratio = clamp(energyOf(bounce) / max(energyOf(bounce - 1u), 1.0), 0.0, frame.faces.z);
    return ratio / (1.0 - ratio);
}

void main() {
    TRIP(VCT_TRIPS_BOUNCE);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    vec3 rest = tail();
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_BOUNCE_FACE);
        ListedFace listed = listedFace(level, i);
        uint occupied = texelFetch(slots, listed.voxel >> VCT_PATCH_LEVEL, VCT_PATCH_LEVEL).r;
        if ((occupied >> VCT_FACE_MASK_BITS) >= patchPlaces()) continue;
        uint patchAt = patchIndex(occupied, listed.face);
        vec3 light = patchLight(patchAt + VCT_PATCH_LIGHT);
        light = max(light + rest * (light - patchLight(patchAt + VCT_PATCH_BEFORE)), 0.0);
        FaceSum sum = faceSum(texelFetch(slots, listed.voxel, 0).r - 1u, listed.face);
        vec3 radiance = sum.radiance + sum.albedo * light / frame.faces.y;
        ivec3 texel = faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, frame.grid.x);
        imageStore(faces, texel, storedFace(vec4(radiance, sum.coverage), texel));
    }
}
