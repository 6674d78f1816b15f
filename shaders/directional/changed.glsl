// Tells which static faces a new pose leaves as they are: those away from the moving objects in that pose and
// in the last one.
#include "directional/cascades.glsl"
#include "directional/face_lists.glsl"

// The lower and upper corner of the box around the objects in both poses, volume space.
layout(location = VCT_UNIFORM_CHANGED) uniform vec3 changedBox[2];
bool isUnchanged(uint id, ivec3 voxel) {
    // An object covers voxels up to 1 beyond its box. A face's extent depends on the next voxels, and a link
    // on extents up to two voxels away.
    const float reach = 5.0;
    int cascade = cascadeOf(voxel);
    vec3 below = voxelsFromVolume(changedBox[0], cascade) - vec3(voxel),
         above = vec3(voxel) - voxelsFromVolume(changedBox[1], cascade);
    return id < commands[0].faceCapacity && any(greaterThan(max(below, above), vec3(reach)));
}
