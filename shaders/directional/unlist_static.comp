// Removes the static faces of cascades that have moved from the index and from the blocks, before scroll.comp
// lists them where they are now. Only with cascades.
#include "directional/block_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform highp uimage3D index;
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit per cascade

void main() {
    uint count = faceCount(0u);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint id = gl_GlobalInvocationID.x; id < count; id += stride) {
        ListedFace listed = baseFace(id);
        if (listed.isMerged || (moved >> uint(cascadeOf(listed.voxel)) & 1u) == 0u) continue;
        ivec3 block = listed.voxel >> VCT_BRICK_LEVEL;
        uint bits = blockWords(block, listed.face, false);
        faceData[bits] = 0u;
        faceData[bits + 1u] = 0u;
        uint shift;
        faceData[maskAt(block, shift)] = 0u;  // the other blocks of the word are of the same cascade
        imageStore(index, listed.voxel, uvec4(0u));
    }
}
