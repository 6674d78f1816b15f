// The faces that resolve.comp and then extents.comp visit. Static faces come first, once they have been
// voxelized, and keep their surface from pose to pose. The dynamic faces of each pose follow. A face that
// static and dynamic geometry share has two ids: at the static one are both together, and at the dynamic one
// is the static geometry alone, for rays whose hits are kept while objects move, and for the next pose.
#include "directional/face_lists.glsl"
#include "directional/face_sums.glsl"
#include "directional/index.glsl"
#include "directional/shared_face.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
// 0: all static faces; VCT_LIST_VISITED: those that are listed there; or the dynamic list.
layout(location = VCT_UNIFORM_LIST) uniform uint list;

struct ResolvedFace {
    uint id;  // that has the surface
    ivec3 voxel;
    int face;
    uint staticCell, dynamicCell;  // of the voxel; static faces are without the dynamic geometry
    uint dynamicId;                // of a face that static and dynamic geometry share; else noIds
    bool changes;                  // false: no face has the id, or it has no sums
};
ResolvedFace resolvedFace(uint i) {
    uint id =
        list == uint(VCT_LIST_VISITED) ? faceData[commands[list].firstFace + i] : commands[list].firstId + i;
    ListedFace listed = baseFace(id);
    uint staticCell = staticCellAt(listed.voxel);
    if (id < commands[0].faceCapacity)
        return ResolvedFace(id, listed.voxel, listed.face, staticCell, 0u, noIds,
                            !listed.isMerged && hasStaticSums(id));
    SharedFace pair = sharedFace(listed, id);
    uint dynamicCell = dynamicCellAt(listed.voxel);
    return ResolvedFace(pair.isShared ? pair.staticId : id, listed.voxel, listed.face, staticCell,
                        dynamicCell, pair.isShared ? id : noIds, pair.isListed);
}
// Another voxel, as far as the face's surface may meet others there.
ResolvedFace inVoxel(ResolvedFace own, ivec3 voxel) {
    uint dynamicCell = list == dynamicList ? dynamicCellAt(voxel) : 0u;
    return ResolvedFace(own.id, voxel, own.face, staticCellAt(voxel), dynamicCell, noIds, own.changes);
}

// A bit for each face of the voxel.
uint facesBeside(ResolvedFace own) {
    return (own.staticCell | own.dynamicCell) & VCT_FACE_MASK;
}
