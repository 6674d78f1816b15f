// Lists the faces that gather in this step: faces that have a turn (directional/gather_turns.glsl), and faces
// without a history. While only cascades move, also lists the active faces, which take part in the other
// passes of the step: those that gather, those without radiance, and a share of those with a short history.
#include "directional/face_sums.glsl"
#include "directional/voxels.glsl"
#include "directional/gather_turns.glsl"
#include "directional/last_lookups.glsl"
#include "shared/frame.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

shared uint groupRays[2];  // rays of one turn: of the faces that pixels look up, and of the others

void main() {
    COUNT(VCT_COUNTER_CHOOSE_FACES);
    if (gl_LocalInvocationIndex < 2u) groupRays[gl_LocalInvocationIndex] = 0u;
    if (gl_GlobalInvocationID.x < VCT_LIGHT_SUMS)
        faceIrradianceData[lightSums(lightStep.frame + 1u) + gl_GlobalInvocationID.x] = 0u;
    barrier();
    uint sums = lightSums(lightStep.frame);
    if (gl_GlobalInvocationID.x < 2u) countTurns(gl_GlobalInvocationID.x == 0u);
    uint count = baseFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_CHOOSE_FACES_FACE);
        uint id = baseFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        ivec3 block = listed.voxel >> VCT_BRICK_LEVEL;
        bool lookedUp = isLookedUp(
            faceTexel(block, listed.face >> 1, listed.face & 1, frame.gridSide >> VCT_BRICK_LEVEL));
        FaceIrradiance mean = faceIrradianceAt(id);
        bool hasLongHistory = lightStep.longEnough > 0.0 && mean.steps >= lightStep.longEnough;
        bool isChosen =
            !hasLongHistory && (mean.steps == 0.0 || turnOf(listed.voxel, listed.face >> 1, lookedUp).isNow);
        bool hasNoRadiance = faceData[faceAt(id) + VCT_FACE_RADIANCE] == 0u;
        bool hasTurn =
            !hasLongHistory && (i / uint(VCT_LIST_GROUP) + lightStep.frame) % VCT_TURN_PERIOD == 0u;
        if (VCT_CASCADES > 1 && lightStep.longEnough > 0.0 && (isChosen || hasNoRadiance || hasTurn)) {
            uint before = atomicAdd(faceIrradianceData[sums + VCT_SUM_ACTIVE], 1u);
            faceIrradianceData[lightStep.lastActiveFace - before] = id;
        }
        if (hasLongHistory) continue;
        atomicAdd(groupRays[lookedUp ? 0 : 1], isNearSurfaces(mean) ? uint(VCT_MIN_CREASE_RAYS) : 1u);
        if (!isChosen) continue;
        uint chosen = atomicAdd(faceIrradianceData[sums + VCT_SUM_CHOSEN], 1u);
        faceIrradianceData[lightStep.chosenFaces + chosen] = id | (lookedUp ? lookedUpFlag : 0u);
    }
    barrier();
    if (gl_LocalInvocationIndex < 2u)
        atomicAdd(faceIrradianceData[sums + VCT_SUM_LOOKED_UP_RAYS + gl_LocalInvocationIndex],
                  groupRays[gl_LocalInvocationIndex]);
}
