// Lists the faces of the listed voxels, which gives them their ids, and lists their parents at all levels
// above. The first child face that sets the bit of a parent's face lists it.
#include "directional/face_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui,
       binding = VCT_IMAGE_VOXELS) coherent uniform uimage3D index;  // the index of the faces in `list`
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D
    staticIndex;  // empty while the static geometry is listed
layout(location = VCT_UNIFORM_LEVEL) uniform uint list;

// Sets the bits of a parent's faces, and returns the bits that are new.
uint markParent(uint level, uvec3 parent, uint faces) {
    uint side = uint(imageSize(index).x) >> level;
    uint place = parent.x + side * (parent.y + side * parent.z);
    uint shift = 8u * (place & 3u);
    uint before =
        atomicOr(faceData[commands[level].firstMask + place / 4u], faces << shift) >> shift & VCT_FACE_MASK;
    if (before == 0u) appendVoxel(level, parent);
    return faces & ~before;
}

void listParents(ivec3 voxel, uint faces) {
    uint levels = uint(findMSB(imageSize(index).x));
    for (uint level = 1u; level <= levels && faces != 0u; ++level) {
        COUNT(VCT_COUNTER_LIST_FACES_LEVEL);
        voxel >>= 1;
        faces = markParent(level, uvec3(voxel), faces);
        uint i = faces == 0u ? 0u : reserveFaces(level, uint(bitCount(faces)));
        for (uint left = faces; left != 0u; left &= left - 1u) {
            COUNT(VCT_COUNTER_LIST_FACES_PARENT);
            storeListed(level, i++, voxel, findLSB(left), 0u);
        }
    }
}

void main() {
    COUNT(VCT_COUNTER_LIST_FACES);
    uint count = activeVoxelCount(list);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint v = gl_GlobalInvocationID.x; v < count; v += stride) {
        COUNT(VCT_COUNTER_LIST_FACES_VOXEL);
        ivec3 voxel = ivec3(activeVoxel(list, v));
        uint faces = imageLoad(index, voxel).r & VCT_FACE_MASK;
        bool isDynamic = (list & ~1u) == uint(VCT_LIST_DYNAMIC);
        uint known = isDynamic ? texelFetch(staticIndex, voxel, 0).r : 0u;
        if (list != 0u && known == 0u) appendVoxel(0u, uvec3(voxel));
        uint first = reserveFaces(list, uint(bitCount(faces))), i = first;
        imageStore(index, voxel, uvec4(packCell(first, faces)));
        for (uint left = faces; left != 0u; left &= left - 1u) {
            COUNT(VCT_COUNTER_LIST_FACES_FACE);
            int face = findLSB(left);
            storeListed(list, i++, voxel, face, hasFace(known, face) ? VCT_MERGED_FACE : 0u);
        }
        listParents(voxel, faces & ~known);
    }
}
