// Lists the static voxels that the cascades still hold after they have moved. Their faces keep their ids, and
// the ids of the others are free. Only with cascades.
#include "directional/block_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform highp uimage3D index;
layout(location = VCT_UNIFORM_REBUILDS) uniform uint rebuilds;               // 1: sums begin at 0 again
layout(location = VCT_UNIFORM_SHIFT) uniform uint shifts[VCT_MAX_CASCADES];  // packShift() of each cascade

#include "directional/face_sums.glsl"

void clearSums(uint id) {
    uint at = sumsAt(id);
    for (uint word = 0u; word < faceSumWords; ++word)
        faceSumData[at + word] = 0u;
}

void main() {
    COUNT(VCT_COUNTER_SCROLL);
    uint total = faceCount(0u), list = commands[0].firstFace;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint id = gl_GlobalInvocationID.x; id < total; id += stride) {
        COUNT(VCT_COUNTER_SCROLL_FACE);
        uint entry = faceData[list + id];
        if (entry == VCT_FREE_FACE || (entry & VCT_FIRST_FACE) == 0u) continue;
        ivec3 voxel = unpackListed(entry).voxel;
        ivec3 now = voxel - unpackShift(shifts[cascadeOf(voxel)]);
        bool stays = now == clampToCascade(now, voxel, frame.gridSide);
        // The other faces of the voxel follow, without the mark of a first face.
        uint faces = 0u, count = 0u;
        do {
            COUNT(VCT_COUNTER_SCROLL_OF_VOXEL);
            int face = int(unpackFace(entry));
            faces |= 1u << uint(face);
            if (stays)
                storeListed(0u, id + count, now, face, entry & VCT_FIRST_FACE);
            else
                faceData[list + id + count] = VCT_FREE_FACE;
            if (!stays || rebuilds != 0u) clearSums(id + count);
            ++count;
            entry = id + count < total ? faceData[list + id + count] : VCT_FREE_FACE;
        } while (count < 6u && (entry & VCT_FIRST_FACE) == 0u);
        if (stays) {
            if (now != voxel) imageStore(index, now, uvec4(packCell(id, faces)));
            appendVoxel(0u, uvec3(now));
            addToBlock(now, faces, faces, false);
        } else {
            for (uint word = 0u; word < 2u; ++word) {
                uint bits = bitsOfIds(id, count, word);
                atomicOr(faceData[freeAt(id) + word], bits);
                atomicAnd(faceData[freshAt(id) + word], ~bits);
            }
        }
    }
}
