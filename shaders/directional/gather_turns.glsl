// The turns of faces in the gather. While something changes, a step traces about lightStep.rayBudget rays,
// whatever the scene and the grid. Faces take turns: in each step a share of them, the rate, gathers. Faces
// that pixels have looked up recently have four times the rate of the others. The rate follows from the
// number of rays in one turn of all faces, which the previous step counted.
#include "directional/face_irradiance.glsl"

#define VCT_SUM_LOOKED_UP_RAYS 15u  // rays in one turn of all faces that pixels have looked up recently
#define VCT_SUM_OTHER_RAYS 16u      // rays in one turn of the other faces
#define VCT_SUM_CHOSEN 17u          // number of faces that gather in the step
// Two floats, stored as bits: the turns so far of faces that pixels have looked up recently, and of the
// others.
#define VCT_SUM_TURNS 18u
#define VCT_SUM_ACTIVE 20u  // number of active faces (directional/active_faces.glsl)

// This bit of an entry in the list of gathering faces marks faces that pixels have looked up recently.
const uint lookedUpFlag = 0x80000000u;

// Turns per step; 1 if there is no budget, or if it suffices for all faces.
float turnRate(bool lookedUp) {
    uint before = lightSums(lightStep.frame + 2u);
    float lookedUpRays = float(faceIrradianceData[before + VCT_SUM_LOOKED_UP_RAYS]);
    float otherRays = float(faceIrradianceData[before + VCT_SUM_OTHER_RAYS]);
    float budget = float(lightStep.rayBudget);
    if (lightStep.rayBudget == 0u || lookedUpRays + otherRays <= budget) return 1.0;
    return min(budget / (lookedUpRays + 0.25 * otherRays), 1.0) * (lookedUp ? 1.0 : 0.25);
}

float turnsBefore(bool lookedUp) {
    uint before = lightSums(lightStep.frame + 2u) + VCT_SUM_TURNS;
    return uintBitsToFloat(faceIrradianceData[before + (lookedUp ? 0u : 1u)]);
}
// Adds the step's turns. The count restarts at 256, which every number of directions divides.
void countTurns(bool lookedUp) {
    uint now = lightSums(lightStep.frame) + VCT_SUM_TURNS;
    faceIrradianceData[now + (lookedUp ? 0u : 1u)] =
        floatBitsToUint(mod(turnsBefore(lookedUp) + turnRate(lookedUp), 256.0));
}

// The number of a face's turn, and whether it has one in this step. The 16 faces of a block's layer have
// their turns in the order of their directions (directional/gather.comp), so those that gather in the same
// step have consecutive ones, which are spread over the hemisphere. All blocks that pixels look up gather the
// same places at the same time, so that no block is noisier than its neighbours. Other blocks have an offset
// by a hash of their position, to distribute the work evenly over the steps.
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
