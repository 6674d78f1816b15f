// The lists of a level's voxels and faces, from those of the level below: the first child to arrive appends its parent.
#include "directional/face_list.glsl"

layout(r32ui, binding = VCT_IMAGE_VOXELS_NEXT) coherent uniform uimage3D parents;

// `level`: of the parent. `faces` (bits): those of a child that are not empty. Lists the parent, and returns the faces
// that are the caller's to list.
uint listParent(uint level, ivec3 parent, uint faces) {
    uint before = imageAtomicOr(parents, parent, faces);
    if (before == 0u) imageAtomicOr(parents, parent, appendVoxel(level, uvec3(parent)) << VCT_FACE_MASK_BITS);
    return faces & ~before;
}
