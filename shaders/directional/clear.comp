// Empties what the last frame listed, of a level above the base level: faces, and the voxels that they are of.
#include "shared/counters.glsl"
#include "directional/face_list.glsl"
#include "directional/voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform uimage3D voxels;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    COUNT(VCT_COUNTER_FACE_CLEAR);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    int grid = imageSize(faces).z;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_FACE_CLEAR_FACE);
        ListedFace listed = listedFace(level, i);
        imageStore(faces, faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, grid), vec4(0.0));
        imageStore(voxels, listed.voxel, uvec4(0u));
    }
}
