// Empties the faces of one level that the last frame listed, and with the base level their sums.
#include "shared/trips.glsl"
#include "shared/face_list.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D slots;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    TRIP(VCT_TRIPS_FACE_CLEAR);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    int grid = imageSize(faces).z;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_FACE_CLEAR_FACE);
        ListedFace listed = listedFace(level, i);
        imageStore(faces, faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, grid), vec4(0.0));
        if (level > 0u) continue;
        TRIP(VCT_TRIPS_FACE_CLEAR_SUMS);
        uint index = faceSumIndex(texelFetch(slots, listed.voxel, 0).r - 1u, listed.face);
        for (uint word = 0u; word < VCT_FACE_SUM_WORDS; ++word)
            faceSums[index + word] = 0u;
    }
}
