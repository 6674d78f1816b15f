// The faces that resolve.comp and then extents.comp visit after a pose has been voxelized. A face that static
// and dynamic geometry share has two ids: at the static one are both together, and at the dynamic one is the
// static geometry alone, for rays whose hits are kept while objects move. In a scene with cascades in which
// nothing moves, they visit the faces that have no light yet; the others stay as they are.
#include "directional/changed.glsl"
#include "directional/index.glsl"
#include "directional/visited.glsl"
#include "directional/face_sums.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

struct ResolvedFace {
    ivec3 voxel;
    int face;
    uint staticCell, dynamicCell;  // of the voxel
    bool isStatic;                 // its surface is that of the static geometry alone
    bool changes;                  // false: no face has the id, or the pose leaves it as it is
};
ResolvedFace resolvedFace(uint id) {
    ListedFace listed = baseFace(id);
    if (listed.isMerged && id < commands[0].faceCapacity || isUnchanged(id, listed.voxel))
        return ResolvedFace(listed.voxel, listed.face, 0u, 0u, false, false);
    uint staticCell = staticCellAt(listed.voxel), dynamicCell = dynamicCellAt(listed.voxel);
    bool isStatic = listed.isMerged || !hasFace(dynamicCell, listed.face);
    return ResolvedFace(listed.voxel, listed.face, staticCell, dynamicCell, isStatic, true);
}
// Another voxel, as far as the face's surface may meet others there.
ResolvedFace inVoxel(ResolvedFace own, ivec3 voxel) {
    return ResolvedFace(voxel, own.face, staticCellAt(voxel), dynamicCellAt(voxel), own.isStatic,
                        own.changes);
}

// The cell of the dynamic geometry, if the surface has any.
uint movingCell(ResolvedFace own) {
    return own.isStatic ? 0u : own.dynamicCell;
}
// A bit for each face of the voxel.
uint facesBeside(ResolvedFace own) {
    return (own.staticCell | movingCell(own)) & VCT_FACE_MASK;
}
