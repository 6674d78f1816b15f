// One step of the gather: the faces that choose_faces.comp listed trace a few rays and add the mean of them
// to their history: the light that arrives, and ambient visibility, the share of the rays that meet nothing
// within the ambient-occlusion distance.
#include "directional/face_lists.glsl"
#define VCT_RAY_STEP VCT_COUNTER_GATHER_STEP
#define VCT_RAY_FACE VCT_COUNTER_GATHER_VOXEL_FACE
#define VCT_RAY_LIMIT VCT_COUNTER_GATHER_LIMIT
#include "directional/ray.glsl"
#include "directional/irradiance.glsl"
#include "directional/gather_directions.glsl"
#include "directional/gather_turns.glsl"
#include "directional/light_sums.glsl"
#include "directional/sky_light.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// The work group's sums of gathered light: three channels from other faces, then three from the sky.
const uint sumCount = 6u;
shared uint groupSums[sumCount];

struct Gathered {
    vec3 light;
    VisibleSky sky;
    float visibility;
    float nearness;  // mean of 1 / distance to the surfaces that the rays meet, in voxels
};

// Traces `rays` rays of a face, along consecutive directions of the set from `firstDirection` on. From one
// direction to the next the azimuth turns by about the golden angle, so that any few consecutive ones are
// spread over the hemisphere. Neighbouring faces begin at different directions: a block has 4^3 voxels, one
// layer of it has 4 x 4 faces, and these begin at 16 consecutive directions.
Gathered gather(ListedFace listed, uint id, uint firstDirection, int rays) {
    // Odd, so that its multiples modulo the number of directions, a power of two, reach every direction.
    const int golden = (VCT_GATHER_DIRECTIONS * 618 / 1000) | 1;
    const float nearest = 0.5;  // bounds the nearness, in voxels
    SurfacePlane plane = facePlane(id);
    int axis = listed.face >> 1, cascade = cascadeOf(listed.voxel);
    vec3 start = surfaceMiddle(listed.voxel, listed.face, plane, faceExtent(id)) + startHeight * plane.normal;
    mat3 axes = frameAround(plane.normal);
    int first = int(firstDirection) + indexInBlock(listed.voxel, axis);
    // Rays reach across the volume, whose diagonal is 1.73 sides long.
    float reach = 2.0 * voxelsAlongVolume(cascade), open = frame.aoDistance * voxelsAlongVolume(cascade);
    Gathered gathered = Gathered(vec3(0.0), VisibleSky(0.0), 0.0, 0.0);
    for (int i = first; i < first + rays; ++i) {
        COUNT(VCT_COUNTER_GATHER_RAY);
        int number = i * golden & (VCT_GATHER_DIRECTIONS - 1);
        vec3 aroundNormal = gatherDirection(number), direction = axes * aroundNormal;
        RayHit hit = traceRay(start, cascade, direction, reach, diceOf(number, listed.voxel));
        if (hit.id == noFace) {
            gathered.sky += visibleSky(direction, gatherSolidAngle(aroundNormal.y));
        } else {
            gathered.light += faceRadiance(hit.id);
            gathered.nearness += 1.0 / max(hit.distance, nearest);
        }
        if (hit.distance > open) gathered.visibility += 1.0;
    }
    float share = 1.0 / float(rays);
    return Gathered(gathered.light * share, gathered.sky * share, gathered.visibility * share,
                    gathered.nearness * share);
}

// Adds a face's light, weighted by its coverage, to the sums of its brick, which cover all faces of the block
// with the same direction (directional/light_blocks.comp).
void addToBlock(ListedFace listed, vec3 light, float coverage) {
    uint brick = brickAt(listed.voxel >> VCT_BRICK_LEVEL, listed.face >> 1, listed.face & 1);
    if (brick == 0u) return;
    uint at = blockSums(brick);
    uvec4 units = uvec4(vec4(min(light / lightRange, 1.0), 1.0) * (coverage * VCT_BLOCK_UNITS) + 0.5);
    for (uint c = 0u; c < 4u; ++c)
        atomicAdd(faceIrradianceData[at + c], units[c]);
}

// Adds a step to a face's history. `known`: length of the history that counts. `stepsNow`: how many steps
// this one counts for. Outside of rounds, recent steps have more weight, because they include more bounces. A
// round is n steps with equal weights, whose mean replaces the history. The history at its first step is kept
// as `roundStart`, and each step adds (light - roundStart) / n. After n steps roundStart has cancelled out.
FaceIrradiance nextMean(FaceIrradiance before, float known, vec4 light, float nearness, float stepsNow) {
    float steps = max(known + stepsNow, lightStep.minHistory),
          share = VCT_RECENT_STEP_WEIGHT / (known + VCT_RECENT_STEP_WEIGHT);
    nearness = mix(before.nearness, nearness, share);
    if (lightStep.roundShare == 0.0 || known == 0.0)
        return FaceIrradiance(mix(before.light, light, share), steps, before.roundStart, nearness);
    vec4 roundStart = lightStep.beginsRound != 0u ? before.light : before.roundStart;
    return FaceIrradiance(max(before.light + (light - roundStart) * lightStep.roundShare, 0.0), steps,
                          roundStart, nearness);
}

void main() {
    COUNT(VCT_COUNTER_GATHER);
    if (gl_LocalInvocationIndex < sumCount) groupSums[gl_LocalInvocationIndex] = 0u;
    barrier();
    uint count = faceIrradianceData[lightSums(lightStep.frame) + VCT_SUM_CHOSEN];
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_GATHER_FACE);
        uint chosen = faceIrradianceData[lightStep.chosenFaces + i];
        uint id = chosen & ~lookedUpFlag;
        ListedFace listed = baseFace(id);
        FaceIrradiance before = faceIrradianceAt(id);
        bool lookedUp = (chosen & lookedUpFlag) != 0u;
        float rate = turnRate(lookedUp);
        uint direction = lightStep.direction;
        // With a budget, a face's direction follows from the number of its turn. The 16 faces of a layer use
        // 16 consecutive directions in one turn, so the next turn begins behind them. The stride is 17 and
        // not 16, because an odd stride leads each face through all directions.
        if (lightStep.rayBudget > 0u)
            direction = 17u * turnOf(listed.voxel, listed.face >> 1, lookedUp).number;
        // Faces along creases are not smoothed (fill_bricks.comp), so their noise would flicker while
        // something changes. They trace more rays and have a longer history.
        float close = closeness(before.nearness);
        // A face with few turns averages fewer steps of its own, or its light would lag by many frames. It is
        // then noisier; the square root of the rate is a compromise.
        float maxSteps = lightStep.maxHistory * sqrt(rate);
        float known = min(before.steps, maxSteps * (1.0 + 2.0 * close * lightStep.smoothing));
        uint rays = isNearSurfaces(before) ? max(lightStep.rays, uint(VCT_MIN_CREASE_RAYS)) : lightStep.rays;
        // A face without a history traces more rays, unless its coverage is so tiny that it hardly counts.
        float coverage = faceExtent(id).coverage;
        bool isNew = known == 0.0 && coverage > 0.02;
        Gathered now = gather(listed, id, direction, int(isNew ? lightStep.initialRays : rays));
        vec3 light = now.light + skyLight(now.sky);
        // Only the share `rate` of the faces gathers in a step, so each counts 1 / rate times in the sums
        // over all faces. Faces without a history always gather, so they count once.
        float weight = weightInSums(listed.voxel) * coverage / (before.steps == 0.0 ? 1.0 : rate);
        uvec3 fromFaces = quantizeSum(now.light * weight, listed.voxel),
              sky = quantizeSum(skyLight(now.sky) * weight, listed.voxel);
        for (uint c = 0u; c < 3u; ++c) {
            atomicAdd(groupSums[c], fromFaces[c]);
            atomicAdd(groupSums[3u + c], sky[c]);
        }
        addToBlock(listed, light, coverage);
        storeFaceIrradiance(id, nextMean(before, known, vec4(light, now.visibility), now.nearness,
                                         isNew ? VCT_INITIAL_HISTORY : 1.0));
    }
    barrier();
    if (gl_LocalInvocationIndex < sumCount)
        atomicAdd(
            faceIrradianceData[lightSums(lightStep.frame) + VCT_SUM_FROM_FACES + gl_LocalInvocationIndex],
            groupSums[gl_LocalInvocationIndex]);
}
