// The base level: the sums of each occupied voxel into the texels of its faces, and the lists of the faces and of their
// parents. VCT_RELIGHT: the lists are there. VCT_STATIC: of the static geometry alone, where something else moves, whose
// faces stay listed from then on. VCT_PART: of a part of the voxels; and the level behind the parents' is emptied of what
// moved.
#include "shared/counters.glsl"
#include "directional/face_list.glsl"
#ifndef VCT_RELIGHT
#include "directional/face_parents.glsl"
#endif
#include "directional/voxels.glsl"
#ifdef VCT_PART
#include "directional/dynamic_faces.glsl"
#endif

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
#ifdef VCT_PART
layout(binding = VCT_TEX_VOXELS) uniform usampler3D index;
#endif
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    COUNT(VCT_COUNTER_FACE_RESOLVE);
    uint count = visitedCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ivec3 voxel = ivec3(unpackEntry(visitedEntry(level, i)));
#ifdef VCT_PART
        uint slot = texelFetch(index, voxel, 0).r - 1u;
#else
        uint slot = i;
#endif
        if (slot >= voxelPlaces()) continue;
        COUNT(VCT_COUNTER_FACE_RESOLVE_VOXEL);
        uint marked = markedFaces(slot);
        if (marked == 0u) continue;
#ifndef VCT_RELIGHT
        uint unlisted = marked;
#ifdef VCT_PART
        unlisted &= ~staticFaces(slot);
#endif
        if (unlisted != 0u) listFaces(level, voxel, unlisted, VCT_COUNTER_FACE_RESOLVE_LISTED);
#ifdef VCT_STATIC
        setMarks(slot, marked, marked);
#endif
        uint ofParent = listParent(level + 1u, voxel >> 1, marked);
        if (ofParent != 0u) listFaces(level + 1u, voxel >> 1, ofParent, VCT_COUNTER_FACE_RESOLVE_PARENT);
#endif
        for (uint left = marked; left != 0u; left &= left - 1u) {
            COUNT(VCT_COUNTER_FACE_RESOLVE_FACE);
            int face = findLSB(left);
            FaceSum sum = faceSum(slot, face);
            ivec3 texel = faceTexel(voxel, face >> 1, face & 1, frame.grid.x);
            imageStore(faces, texel, storedFace(vec4(sum.radiance, sum.coverage), texel, 0u));
        }
    }
#ifdef VCT_PART
    emptyMoving(level + 2u);
#endif
}
