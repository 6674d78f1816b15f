// The rows of voxels that a face's surface passes, along the two axes across the face.
#include "directional/face_lists.glsl"
#include "directional/index.glsl"

// The voxels beside a face, on its surface.
struct Row {
    ivec3 voxel, first;  // the face's voxel, and the first one of its cascade
    vec3 start;          // on the surface, amid the voxel's cross-section, in voxels
    vec3 pace;           // from one voxel of the row to the next
};
Row rowOf(ListedFace listed, SurfacePlane plane, vec2 along) {
    int axis = listed.face >> 1;
    float steepness = 1.0 / plane.normal[axis];
    float height = clamp(plane.offset * steepness, -0.499, 0.499);
    float slope = -dot(acrossFaces(plane.normal, axis), along) * steepness;
    return Row(listed.voxel, firstOfCascade(listed.voxel, frame.gridSide),
               vec3(listed.voxel) + 0.5 + fromAcross(vec2(0.0), height, axis),
               fromAcross(along, slope, axis));
}
ivec3 voxelOfRow(Row row, float paces) {
    return ivec3(floor(row.start + paces * row.pace));
}
// The faces of a voxel: static ones, or dynamic ones if the static ones lack `faces`. None outside of the
// cascade.
uint cellBeside(Row row, ivec3 voxel, uint faces) {
    if (any(greaterThanEqual(uvec3(voxel - row.first), uvec3(frame.gridSide)))) return 0u;
    uint cell = staticCellAt(voxel);
    bool isFound = (cell & faces) != 0u;
    return isFound || frame.hasDynamicObjects == 0 ? cell : dynamicCellAt(voxel);
}
