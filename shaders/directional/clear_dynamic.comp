// Removes dynamic objects from the base level, before a new pose is voxelized: clears their bits in the
// blocks, and the words and the pages of the pose before the last one, which the new pose will use. Static
// faces that they shared have the surface of the static geometry again.
#include "directional/face_lists.glsl"
#include "directional/face_sums.glsl"
#include "directional/shared_face.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba16ui, binding = VCT_IMAGE_PAGES) writeonly uniform highp uimage3D pages;  // of the older pose

void main() {
    uint last = dynamicList, older = last ^ 1u;
    uint lastCount = faceCount(last), olderCount = faceCount(older);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < max(lastCount, olderCount); i += stride) {
        if (i < lastCount) {
            ListedFace listed = listedFace(last, i);
            uint bits = markWords(listed.voxel >> VCT_BRICK_LEVEL, listed.face, true);
            faceData[bits] = 0u;
            faceData[bits + 1u] = 0u;
            uint id = commands[last].firstId + i;
            SharedFace pair = sharedFace(listed, id);
            for (uint word = 0u; word < faceWords && pair.isShared; ++word)
                faceData[faceAt(pair.staticId) + word] = faceData[faceAt(id) + word];
        }
        if (i < olderCount) {
            imageStore(pages, listedFace(older, i).voxel >> VCT_BRICK_LEVEL, uvec4(0u));
            uint id = commands[older].firstId + i, at = sumsAt(id);
            faceData[radianceAt(id)] = 0u;
            for (uint word = 0u; word < faceSumWords; ++word)
                faceSumData[at + word] = 0u;
        }
    }
}
