// The sums of a voxel of the base level into the texels of its faces, and into the lists of the faces and of their parents.
#include "shared/counters.glsl"
#include "directional/face_parents.glsl"
#include "directional/voxels.glsl"

layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;

// `marked` (bits): the faces that are not empty.
void storeFaces(ivec3 voxel, uint slot, uint marked) {
    for (uint left = marked; left != 0u; left &= left - 1u) {
        COUNT(VCT_COUNTER_FACE_RESOLVE_FACE);
        int face = findLSB(left);
        FaceSum sum = faceSum(slot, face);
        ivec3 texel = faceTexel(voxel, face >> 1, face & 1, frame.gridSide);
        imageStore(faces, texel, storedFace(vec4(sum.radiance, sum.coverage), texel, 0u));
    }
}

// `unlisted` (bits): those of the marked faces that are in no list.
void listVoxel(ivec3 voxel, uint marked, uint unlisted) {
    if (unlisted != 0u) listFaces(0u, voxel, unlisted, VCT_COUNTER_FACE_RESOLVE_LISTED);
    uint ofParent = listParent(1u, voxel >> 1, marked);
    if (ofParent != 0u) listFaces(1u, voxel >> 1, ofParent, VCT_COUNTER_FACE_RESOLVE_PARENT);
}
