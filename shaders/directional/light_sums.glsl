// Sums over all faces in a step, for the global energy correction (directional/light_balance.glsl). Each face
// counts by its coverage and its area, and a surface counts in the finest cascade that holds it. If all faces
// counted alike, the sums would be of the surfaces near the camera, which reflect the light of a lamp that
// they hardly hold, and the correction would be wrong.
#include "directional/face_irradiance.glsl"
#include "directional/voxels.glsl"
#include "directional/cascades.glsl"

// Three words each.
#define VCT_SUM_BEFORE 0u      // irradiance before the step
#define VCT_SUM_REFLECTED 3u   // the part of the irradiance before the step that faces reflect
#define VCT_SUM_DIRECT 6u      // emission and reflected direct light
#define VCT_SUM_FROM_FACES 9u  // irradiance by other faces, as gathered in the step
#define VCT_SUM_SKY 12u        // irradiance by the sky, as gathered in the step

// The weight of a face: its area relative to a face of the coarsest cascade, or 0 if a finer cascade holds
// it.
float weightInSums(ivec3 voxel) {
    if (cascades == 1) return 1.0;
    int cascade = cascadeOf(voxel);
    if (cascade > 0 &&
        voxelsInside(volumeFromVoxels(vec3(voxel) + 0.5, cascade), frame.cascade[cascade - 1]) > 0.0)
        return 0.0;
    return exp2(float(2 * (cascade + 1 - cascades)));
}

// Converts a weighted value to fixed point. The sum of integers does not depend on their order. sumUnits
// keeps the sum of all faces within 32 bits if their mean is below 4 (Irradiance::uploadUniforms()); the
// limit of 64 bounds what one face adds. Faces of fine cascades add less than a unit, so they are rounded at
// random.
uvec3 quantizeSum(vec3 value, ivec3 voxel) {
    vec3 rounding = cascades == 1 ? vec3(0.5) : hashNoise(voxel, lightStep.frame);
    return uvec3(min(value / lightRange, 64.0) * lightStep.sumUnits + rounding);
}
