// One more bounce, second half, where another follows: the blocks' faces shine with what their patches received. Cones of
// bounces read no finer level.
#include "shared/trips.glsl"
#include "shared/face_list.glsl"
#include "shared/face_patches.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D slots;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // of the patches

void main() {
    TRIP(VCT_TRIPS_BOUNCE_PATCHES);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_BOUNCE_PATCHES_PATCH);
        ListedFace listed = listedFace(level, i);
        uint occupied = texelFetch(slots, listed.voxel, int(level)).r;
        if ((occupied >> VCT_FACE_MASK_BITS) >= patchPlaces()) continue;
        uint patchAt = patchIndex(occupied, listed.face);
        vec4 face = unpackUnorm4x8(facePatches[patchAt + VCT_PATCH_DIRECT]);
        vec3 light = patchLight(patchAt + VCT_PATCH_LIGHT);
        face.rgb += face.a * patchAlbedo(patchAt) * light / frame.faces.y;
        ivec3 texel = faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, imageSize(faces).z);
        imageStore(faces, texel, storedFace(face, texel));
    }
}
