// Lists the faces of the listed voxels, which gives them their ids, marks the voxels in their blocks, and
// lists the faces of the blocks. The first voxel that sets the bit of a block's face lists it.
#include "directional/blocks.glsl"
#include "directional/face_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui,
       binding = VCT_IMAGE_VOXELS) coherent uniform highp uimage3D index;  // the index of the faces in `list`
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D
    staticIndex;  // empty while the static geometry is listed
layout(location = VCT_UNIFORM_LEVEL) uniform uint list;

const uint bricks = uint(VCT_BRICK_LEVEL);

// Lists these faces of a block, except those that are listed already.
void listInBlock(uvec3 block, uint faces) {
    uint side = uint(frame.gridSide) >> bricks;
    uint place = block.x + side * (block.y + side * block.z), shift = 8u * (place & 3u);
    uint before = atomicOr(faceData[commands[bricks].firstMask + place / 4u], faces << shift) >> shift;
    faces &= ~before;
    uint i = faces == 0u ? 0u : reserveFaces(bricks, uint(bitCount(faces)));
    for (uint left = faces; left != 0u; left &= left - 1u) {
        COUNT(VCT_COUNTER_LIST_FACES_BLOCK_FACE);
        storeListed(bricks, i++, ivec3(block), findLSB(left), 0u);
    }
}

void main() {
    COUNT(VCT_COUNTER_LIST_FACES);
    uint count = activeVoxelCount(list);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    bool isDynamic = (list & ~1u) == uint(VCT_LIST_DYNAMIC);
    for (uint v = gl_GlobalInvocationID.x; v < count; v += stride) {
        COUNT(VCT_COUNTER_LIST_FACES_VOXEL);
        ivec3 voxel = ivec3(activeVoxel(list, v));
        uint faces = imageLoad(index, voxel).r & VCT_FACE_MASK;
        uint known = isDynamic ? texelFetch(staticIndex, voxel, 0).r : 0u;
        if (list != 0u && known == 0u) appendVoxel(0u, uvec3(voxel));
        uint facesHere = uint(bitCount(faces)), first = reserveFaces(list, facesHere), i = first;
        ivec3 block = voxel >> VCT_BRICK_LEVEL;
        uint bit = bitInBlock(voxel);
        bool fits = first + facesHere <= commands[list].faceCapacity;
        imageStore(index, voxel, uvec4(fits ? packCell(commands[list].firstId + first, faces) : 0u));
        for (uint left = faces; left != 0u; left &= left - 1u) {
            COUNT(VCT_COUNTER_LIST_FACES_FACE);
            int face = findLSB(left);
            storeListed(list, i++, voxel, face, hasFace(known, face) ? VCT_MERGED_FACE : 0u);
            if (fits) atomicOr(faceData[blockWords(block, face, isDynamic) + (bit >> 5u)], 1u << (bit & 31u));
        }
        listInBlock(uvec3(block), faces & ~known);
    }
}
