// Empties what the last frame listed, of a level above the base level: faces, and the voxels that they are of. VCT_PART:
// of voxels that the static geometry occupies too, those faces alone.
#include "shared/trips.glsl"
#include "shared/face_list.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
#ifdef VCT_PART
layout(r32ui, binding = VCT_IMAGE_VOXELS) coherent uniform uimage3D voxels;
#else
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform uimage3D voxels;
#endif
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    TRIP(VCT_TRIPS_FACE_CLEAR);
    uint end = endFacesVisited(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    int grid = imageSize(faces).z;
    for (uint i = firstFaceVisited() + gl_GlobalInvocationID.x; i < end; i += stride) {
        TRIP(VCT_TRIPS_FACE_CLEAR_FACE);
        ListedFace listed = visitedFace(level, i);
        imageStore(faces, faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, grid), vec4(0.0));
#ifdef VCT_PART
        uint bit = 1u << uint(listed.face);
        // Which of them are static is not known here: where none is, the last one to go leaves no face behind.
        if ((imageAtomicAnd(voxels, listed.voxel, ~bit) & VCT_FACE_MASK & ~bit) != 0u) continue;
#endif
        imageStore(voxels, listed.voxel, uvec4(0u));
    }
}
