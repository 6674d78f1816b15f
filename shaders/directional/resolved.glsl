// The faces that resolve.comp and then extents.comp visit after a pose has been voxelized. A face that static
// and dynamic geometry share has two ids: at the static one are both together, and at the dynamic one is the
// static geometry alone, for rays whose hits are kept while objects move. In a scene with cascades in which
// nothing moves, they visit the faces that have no light yet; the others stay as they are.
#include "directional/cascades.glsl"
#include "directional/visited.glsl"
#include "directional/face_sums.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_DYNAMIC_VOXELS) uniform highp usampler3D dynamicIndex;

struct ResolvedFace {
    ivec3 voxel;
    int face;
    uint staticCell, dynamicCell;  // of the voxel, as far as the face's surface is among them
    bool exists;                   // false: no face has the id
};
ResolvedFace resolvedFace(uint id) {
    ListedFace listed = baseFace(id);
    bool isStatic = id < commands[0].faceCapacity;
    uint staticCell = texelFetch(staticIndex, listed.voxel, 0).r;
    uint dynamicCell = faceCount(dynamicList) > 0u ? texelFetch(dynamicIndex, listed.voxel, 0).r : 0u;
    if (listed.isMerged || !hasFace(dynamicCell, listed.face)) dynamicCell = 0u;
    return ResolvedFace(listed.voxel, listed.face, staticCell, dynamicCell, !(listed.isMerged && isStatic));
}

// The cells of another voxel, with dynamic geometry if the face's surface has any.
ResolvedFace cellsIn(ResolvedFace own, ivec3 voxel) {
    own.voxel = voxel;
    own.staticCell = texelFetch(staticIndex, voxel, 0).r;
    if (own.dynamicCell != 0u) own.dynamicCell = texelFetch(dynamicIndex, voxel, 0).r;
    return own;
}
