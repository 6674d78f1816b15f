// What moved in the last frame, in a level above the base level: to be taken out, by passes that have other work at other
// levels, as each dispatch has its price.
#include "directional/face_list.glsl"
#include "directional/voxels.glsl"

layout(rgba8, binding = VCT_IMAGE_EMPTIED_FACES) writeonly uniform mediump image3D emptiedFaces;
layout(r32ui, binding = VCT_IMAGE_EMPTIED_VOXELS) coherent uniform uimage3D emptiedVoxels;
// In the level's list of faces, behind those of the static geometry; none where there is no such level.
layout(location = VCT_UNIFORM_EMPTIED) uniform uint firstEmptied;
layout(location = VCT_UNIFORM_EMPTIED_END) uniform uint endEmptied;

// Faces, and voxels that have none then. Nothing may have been listed at that level since.
void emptyMoving(uint level) {
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = firstEmptied + gl_GlobalInvocationID.x; i < endEmptied; i += stride) {
        COUNT(VCT_COUNTER_FACE_CLEAR_FACE);  // whichever pass it is: that is the work
        ListedFace listed = listedFace(level, i);
        int grid = imageSize(emptiedFaces).z;
        imageStore(emptiedFaces, faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, grid), vec4(0.0));
        uint bit = 1u << uint(listed.face);
        // Which of them are static is not known here: where none is, the last one to go leaves no face behind.
        if ((imageAtomicAnd(emptiedVoxels, listed.voxel, ~bit) & VCT_FACE_MASK & ~bit) == 0u)
            imageStore(emptiedVoxels, listed.voxel, uvec4(0u));
    }
}
