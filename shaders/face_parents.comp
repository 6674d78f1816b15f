// The occupied voxels of the next level and their faces: the first child to arrive appends its parent to the lists.
#include "shared/trips.glsl"
#include "shared/face_list.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_VOXELS_NEXT) coherent uniform uimage3D parents;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    TRIP(VCT_TRIPS_FACE_PARENTS);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_FACE_PARENTS_FACE);
        ListedFace listed = listedFace(level, i);
        ivec3 parent = listed.voxel >> 1;
        uint bit = 1u << uint(listed.face);
        uint before = imageAtomicOr(parents, parent, bit);
        if ((before & bit) != 0u) continue;
        appendFace(level + 1u, uvec3(parent), uint(listed.face));
        if (before == 0u) imageAtomicOr(parents, parent, appendVoxel(level + 1u, uvec3(parent)) << VCT_FACE_MASK_BITS);
    }
}
