// Empties a level above the base level of what moved in the last frame: faces, and voxels that have none then.
#include "directional/face_list.glsl"
#include "directional/voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(r32ui, binding = VCT_IMAGE_VOXELS) coherent uniform uimage3D voxels;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;
// In the level's list of faces, behind those of the static geometry.
layout(location = VCT_UNIFORM_FIRST) uniform uint firstMoving;
layout(location = VCT_UNIFORM_END) uniform uint endMoving;

void main() {
    uint i = firstMoving + gl_GlobalInvocationID.x;
    if (i >= endMoving) return;
    ListedFace listed = listedFace(level, i);
    imageStore(faces, faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, imageSize(faces).z), vec4(0.0));
    uint bit = 1u << uint(listed.face);
    // Which of the voxel's faces are static is not known here: where none is, the last one to go leaves none behind.
    if ((imageAtomicAnd(voxels, listed.voxel, ~bit) & VCT_FACE_MASK & ~bit) == 0u)
        imageStore(voxels, listed.voxel, uvec4(0u));
}
