// Lists the faces of the listed voxels, which gives them their ids, marks the voxels in their blocks, and
// lists the faces of the blocks. Of the static geometry these are the voxels that have been added since
// mark_static.comp.
#include "directional/block_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui,
       binding = VCT_IMAGE_VOXELS) coherent uniform highp uimage3D index;  // the index of the faces in `list`
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(location = VCT_UNIFORM_LEVEL) uniform uint list;

// The position in the list of the first of `count` faces; noIds if there is no room.
uint placeOf(uint count) {
    if (list != 0u || commands[0].faceCount < commands[0].faceCapacity) {
        uint first = reserveFaces(list, count);
        if (first + count <= commands[list].faceCapacity) return first;
    }
    if (list != 0u) return noIds;
    uint found = noIds;
#if VCT_CASCADES > 1
    found = takeFreeIds(count);
#endif
    if (found == noIds) atomicAdd(unplacedFaces, count);
    return found;
}

void main() {
    bool isDynamic = list != 0u;
    uint count = activeVoxelCount(list);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint v = (isDynamic ? 0u : commands[0].staticVoxels) + gl_GlobalInvocationID.x; v < count;
         v += stride) {
        ivec3 voxel = ivec3(activeVoxel(list, v));
        uint faces = imageLoad(index, voxel).r & VCT_FACE_MASK;
        uint known = isDynamic ? texelFetch(staticIndex, voxel, 0).r : 0u;
        if (isDynamic && known == 0u) appendVoxel(0u, uvec3(voxel));
        uint facesHere = uint(bitCount(faces)), first = placeOf(facesHere), i = first;
        bool fits = first != noIds;
        imageStore(index, voxel, uvec4(fits ? packCell(commands[list].firstId + first, faces) : 0u));
        for (uint left = faces; left != 0u && fits; left &= left - 1u) {
            int face = findLSB(left);
            uint flags = i == first ? VCT_FIRST_FACE : 0u;
            storeListed(list, i++, voxel, face, flags | (hasFace(known, face) ? VCT_MERGED_FACE : 0u));
        }
        if (VCT_CASCADES > 1 && !isDynamic && fits)
            for (uint word = 0u; word < 2u; ++word)
                atomicOr(faceData[freshAt(first) + word], bitsOfIds(first, facesHere, word));
        if (fits) markInBlock(voxel, faces, isDynamic);
        // The first voxel that sets the bit of a block's face lists it.
        uint shift, at = maskAt(voxel >> VCT_BRICK_LEVEL, shift), listed = faces & ~known;
        uint before = atomicOr(faceData[at], listed << shift) >> shift;
        listOfBlock(voxel >> VCT_BRICK_LEVEL, listed & ~before);
    }
}
