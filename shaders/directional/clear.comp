// Clears the faces that only dynamic objects cover at a level above the base level, before a new pose is
// voxelized.
#include "directional/face_lists.glsl"
#include "directional/voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    COUNT(VCT_COUNTER_FACE_CLEAR);
    uint count = faceCount(level), side = uint(imageSize(faces).x) / 3u;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = commands[level].staticFaces + gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_FACE_CLEAR_FACE);
        ListedFace listed = listedFace(level, i);
        imageStore(faces, faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, int(side)), vec4(0.0));
        uvec3 voxel = uvec3(listed.voxel);
        uint place = voxel.x + side * (voxel.y + side * voxel.z);
        atomicAnd(faceData[commands[level].firstMask + place / 4u],
                  ~(1u << (8u * (place & 3u) + uint(listed.face))));
    }
}
