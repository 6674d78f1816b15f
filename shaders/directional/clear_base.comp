// Empties what the last frame listed, of the base level: voxels, their faces and the faces' sums. VCT_PART: static voxels
// keep their places in the list; and the next level is emptied of what moved.
#include "shared/counters.glsl"
#include "directional/face_list.glsl"
#include "directional/voxels.glsl"
#ifdef VCT_PART
#include "directional/dynamic_faces.glsl"
#endif

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
#ifdef VCT_PART
layout(r32ui, binding = VCT_IMAGE_VOXELS_NEXT) writeonly uniform uimage3D voxels;  // of this level all the same
#else
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform uimage3D voxels;
#endif
layout(binding = VCT_TEX_VOXELS) uniform usampler3D index;     // the same
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    COUNT(VCT_COUNTER_FACE_CLEAR_BASE);
    uint side = uint(frame.grid.x);
    uint count = voxelsToEmpty(level, side);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_FACE_CLEAR_BASE_VOXEL);
        ivec3 voxel = ivec3(voxelToEmpty(level, side, i));
#ifdef VCT_PART
        uint slot = texelFetch(index, voxel, 0).r - 1u;
        if (slot >= firstMoving) imageStore(voxels, voxel, uvec4(0u));
#else
        uint slot = overflowed(level) ? texelFetch(index, voxel, 0).r - 1u : i;
        imageStore(voxels, voxel, uvec4(0u));
#endif
        if (slot >= voxelPlaces()) continue;
        for (uint left = markedFaces(slot); left != 0u; left &= left - 1u) {
            COUNT(VCT_COUNTER_FACE_CLEAR_BASE_FACE);
            int face = findLSB(left);
            imageStore(faces, faceTexel(voxel, face >> 1, face & 1, frame.grid.x), vec4(0.0));
            uint index = faceSumIndex(slot, face);
            for (uint word = 0u; word < VCT_FACE_SUM_WORDS; ++word)
                faceSums[index + word] = 0u;
        }
#ifdef VCT_PART
        setMarks(slot, 0u, staticFaces(slot));
#else
        setMarks(slot, 0u, 0u);
#endif
    }
#ifdef VCT_PART
    emptyMoving(level + 1u);
#endif
}
