// The faces of the present pose that static and dynamic geometry share.
#include "directional/face_lists.glsl"
#include "directional/index.glsl"

struct SharedFace {
    bool isListed;  // the index has the dynamic face; false: its list had no room for the voxel
    bool isShared;
    uint staticId;  // if they share it
};
SharedFace sharedFace(ListedFace listed, uint dynamicId) {
    uint dynamicCell = dynamicCellAt(listed.voxel), staticCell = staticCellAt(listed.voxel);
    bool isListed = hasFace(dynamicCell, listed.face) && faceId(dynamicCell, listed.face) == dynamicId,
         isShared = isListed && hasFace(staticCell, listed.face);
    return SharedFace(isListed, isShared, isShared ? faceId(staticCell, listed.face) : 0u);
}
