// The turns of the gather. While something changes, a step traces about lightStep.coneBudget cones, whatever the scene and
// the grid, and faces take turns: in each step a share of them, the rate, gathers. Faces that pixels have looked up lately
// have four times the rate of the others. It follows from the cones that one turn of all faces takes, which the step before
// has counted.
#include "directional/face_irradiance.glsl"

#define VCT_SUM_LOOKED_UP_CONES 15u  // cones that a turn takes of all faces that pixels have looked up lately
#define VCT_SUM_OTHER_CONES 16u
#define VCT_SUM_CHOSEN 17u  // faces that gather in the step
#define VCT_SUM_TURNS 18u   // bits of two floats: turns of the faces that pixels have looked up lately, and of the others,
                            // this step included

// Bit of an entry in the list of the faces that gather.
const uint lookedUpFlag = 0x80000000u;

// Turns per step; 1 where nothing changes, or the budget holds all faces.
float turnRate(bool lookedUp) {
    uint before = lightSums(lightStep.frame + 2u);
    float lookedUpCones = float(faceIrradianceData[before + VCT_SUM_LOOKED_UP_CONES]);
    float otherCones = float(faceIrradianceData[before + VCT_SUM_OTHER_CONES]);
    float budget = float(lightStep.coneBudget);
    if (lightStep.coneBudget == 0u || lookedUpCones + otherCones <= budget) return 1.0;
    return min(budget / (lookedUpCones + 0.25 * otherCones), 1.0) * (lookedUp ? 1.0 : 0.25);
}

float turnsBefore(bool lookedUp) {
    uint before = lightSums(lightStep.frame + 2u) + VCT_SUM_TURNS;
    return uintBitsToFloat(faceIrradianceData[before + (lookedUp ? 0u : 1u)]);
}
// From 256 on they begin at 0 again: by then a face has come to all directions.
void countTurns(bool lookedUp) {
    uint now = lightSums(lightStep.frame) + VCT_SUM_TURNS;
    faceIrradianceData[now + (lookedUp ? 0u : 1u)] = floatBitsToUint(mod(turnsBefore(lookedUp) + turnRate(lookedUp), 256.0));
}

// The number of a face's turn, and whether it gathers in this step. The 16 faces of a flat block look into 16 directions in a
// row (directional/gather.comp), and any few in a row are spread over the hemisphere: so faces in a row gather in one step.
// All blocks that pixels look up do so in step, which keeps them alike.
struct Turn {
    uint number;
    bool isNow;
};
Turn turnOf(ivec3 voxel, int axis, bool lookedUp) {
    ivec3 block = voxel >> VCT_BRICK_LEVEL;
    float before = turnsBefore(lookedUp) + 1.0 - float(indexInBlock(voxel, axis)) / 16.0;
    if (!lookedUp) before += float((185 * block.x + 407 * block.y + 111 * block.z) & 255) / 256.0;
    float number = floor(before + turnRate(lookedUp));
    return Turn(uint(number), number > floor(before));
}
