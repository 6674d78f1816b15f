// The sums of every face of the base level into its texel.
#include "shared/trips.glsl"
#include "shared/face_list.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D slots;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    TRIP(VCT_TRIPS_FACE_RESOLVE);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_FACE_RESOLVE_FACE);
        ListedFace listed = listedFace(level, i);
        FaceSum sum = faceSum(texelFetch(slots, listed.voxel, 0).r - 1u, listed.face);
        ivec3 texel = faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, frame.grid.x);
        imageStore(faces, texel, storedFace(vec4(sum.radiance, sum.coverage), texel));
    }
}
