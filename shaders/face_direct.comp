// Before the coarser levels of a frame that makes some blocks anew: elsewhere the blocks' faces shine with direct light
// alone again, which their patches keep.
#include "shared/trips.glsl"
#include "shared/changed_blocks.glsl"
#include "shared/face_list.glsl"
#include "shared/face_patches.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D slots;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // of the patches

void main() {
    TRIP(VCT_TRIPS_FACE_DIRECT);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ListedFace listed = listedFace(level, i);
        if (isChanged(listed.voxel << level)) continue;
        TRIP(VCT_TRIPS_FACE_DIRECT_PATCH);
        uint occupied = texelFetch(slots, listed.voxel, int(level)).r;
        vec4 face = unpackUnorm4x8(facePatches[patchIndex(occupied, listed.face) + VCT_PATCH_DIRECT]);
        imageStore(faces, faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, imageSize(faces).z), face);
    }
}
