// The lists of a level's voxels and faces, from those of the level below: the first child to arrive appends its parent.
#include "shared/face_list.glsl"

layout(r32ui, binding = VCT_IMAGE_VOXELS_NEXT) coherent uniform uimage3D parents;

// `level`: of the child, not the last one. `faces` (bits): those that are not empty.
void listParents(uint level, ivec3 voxel, uint faces) {
    ivec3 parent = voxel >> 1;
    uint before = imageAtomicOr(parents, parent, faces);
    uint added = faces & ~before;
    if (added == 0u) return;
    listFaces(level + 1u, parent, added, level == 0u ? VCT_TRIPS_FACE_RESOLVE_PARENT : VCT_TRIPS_FACE_MIPMAPPER_PARENT);
    if (before == 0u) imageAtomicOr(parents, parent, appendVoxel(level + 1u, uvec3(parent)) << VCT_FACE_MASK_BITS);
}
