// One step of the gather: the faces that choose_faces.comp listed trace a few cones and add the mean of them
// to their history. VCT_GATHER_OCCLUSION (true or false): they gather ambient visibility in place of light.
#include "directional/face_sums.glsl"
#include "directional/cones.glsl"
#include "directional/irradiance.glsl"
#define VCT_COUNTER_CONTACT_VOXEL VCT_COUNTER_IRRADIANCE_VOXEL
#define VCT_COUNTER_CONTACT_FACE VCT_COUNTER_IRRADIANCE_OTHER_FACE
#include "directional/contact.glsl"
#include "directional/gather_directions.glsl"
#include "directional/gather_turns.glsl"
#include "directional/light_sums.glsl"
#include "directional/sky_light.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

const bool occlusion = VCT_GATHER_OCCLUSION;

// The work group's sums of gathered light: three channels from other faces, then three from the sky.
const uint sumCount = 6u;
shared uint groupSums[sumCount];

struct Gathered {
    vec3 light;
    VisibleSky sky;
    float nearness;  // mean of 1 / distance to the surfaces that the cones meet, in voxels
};

// The radiance of a face, relative to E/pi, of the surface that covers it.
mediump vec3 radianceOf(ivec3 voxel, int face) {
    mediump vec4 stored = texelFetch(faces, faceTexel(voxel, face >> 1, face & 1, frame.gridSide), 0);
    return stored.rgb * (faceRange.radiance / max(stored.a, 1e-2));
}

// The thin walls beside a face: positions along the two axes that it spans (acrossFaces()), in voxels.
vec2 thinWallsBeside(ivec3 voxel, int face) {
    ivec3 block = voxel >> VCT_BRICK_LEVEL;
    int axis = face >> 1;
    if ((brickAt(block, axis, face & 1) & VCT_BRICK_HAS_WALLS) == 0u) return vec2(noWall);
    ivec3 texel = faceTexel(block, axis, face & 1, frame.gridSide >> VCT_BRICK_LEVEL);
    vec2 first = acrossFaces(vec3(block * VCT_BRICK_SIDE - 1), axis);
    WallsBeside found =
        wallsBeside(texelFetch(walls, texel, 0).r, acrossFaces(vec3(voxel) + 0.5, axis) - first);
    return mix(vec2(noWall), first + found.position, found.crosses);
}

// Radiance and coverage of a thin wall that a ray meets near its start, from a face along `axis`. A cone's
// samples would let light through a wall that is within the first step.
mediump vec4 thinWallOnRay(vec2 thinWalls, int axis, vec3 start, vec3 direction) {
    const float near = 2.0;  // voxels
    vec2 along = acrossFaces(direction, axis);
    vec2 distances = (thinWalls - acrossFaces(start, axis)) / along;
    distances = mix(vec2(near), distances, greaterThan(distances, vec2(0.0)));
    float distance = min(distances.x, distances.y);
    if (distance >= near) return vec4(0.0);
    bool isFirst = distances.x < distances.y;
    int wallAxis = (axis + (isFirst ? 1 : 2)) % 3;
    // The wall's faces look against the ray.
    int side = (isFirst ? along.x : along.y) > 0.0 ? 1 : 0;
    ivec3 from = ivec3(start),
          voxel = clampToCascade(ivec3(start + direction * distance), from, frame.gridSide);
    mediump vec4 wall = texelFetch(faces, faceTexel(voxel, wallAxis, side, frame.gridSide), 0);
    if (wall.a > 0.0) return wall;
    // The plane of the wall's middle may be in the voxel behind its surface.
    voxel[wallAxis] += side == 1 ? -1 : 1;
    voxel = clampToCascade(voxel, from, frame.gridSide);
    return texelFetch(faces, faceTexel(voxel, wallAxis, side, frame.gridSide), 0);
}

// Traces `cones` cones of a face, along consecutive directions of the set from `firstDirection` on. From one
// direction to the next the azimuth turns by about the golden angle, so that any few consecutive ones are
// spread over the hemisphere. Neighbouring faces begin at different directions: a block has 4^3 voxels, one
// layer of it has 4 x 4 faces, and these begin at 16 consecutive directions. `ownBelow`: the result of
// ownFaces(), which keeps the cones from meeting the face's own surface.
Gathered gather(ivec3 voxel, int face, SurfacePlane plane, vec3 ownBelow, uint firstDirection, int cones) {
    // Odd, so that its multiples modulo the number of directions, a power of two, reach every direction.
    const int golden = (VCT_GATHER_DIRECTIONS * 618 / 1000) | 1;
    ConeStart start = coneStartOf(voxel, face, plane);
    mediump vec3 oppositeLight =
        start.opposite == vec3(0.0) ? vec3(0.0) : radianceOf(start.voxel, start.face);
    vec2 thinWalls = thinWallsBeside(voxel, face);
    int place = indexInBlock(voxel, face >> 1);
    int first = int(firstDirection) + place;
    // Cones for light reach across the volume, whose diagonal is 1.73 sides long.
    int cascade = cascadeOf(voxel);
    float reach = (occlusion ? frame.aoDistance : 2.0) * voxelsAlongVolume(cascade);
    const float behindVoxel = 0.8;  // half a voxel is the middle of the next voxel's faces
    Gathered gathered = Gathered(vec3(0.0), VisibleSky(0.0), 0.0);
    for (int i = first; i < first + cones; ++i) {
        COUNT(VCT_COUNTER_IRRADIANCE_CONE);
        vec3 aroundNormal = gatherDirection(i * golden & (VCT_GATHER_DIRECTIONS - 1));
        vec3 direction = frameAround(plane.normal) * aroundNormal;
        // The width varies by a factor of 2^-0.5 to 2^0.5, so that the cones do not all change their level at
        // the same height. It depends only on face and direction (multiplied by an odd number, as a hash), so
        // that a direction has the same cone in each round.
        int noise = (i & (VCT_GATHER_DIRECTIONS - 1)) * 49471 + 4096 * place;
        float spread = exp2(float(noise & 65535) / 65536.0 - 0.5);
        float toOpposite = distanceToOpposite(start, direction);
        if (toOpposite >= 0.0) {
            gathered.light += oppositeLight;
            gathered.nearness += 1.0 / max(toOpposite, VCT_GATHER_FIRST_SAMPLE);
            continue;
        }
        if (max(thinWalls.x, thinWalls.y) > -1.0) {
            mediump vec4 wall = thinWallOnRay(thinWalls, face >> 1, start.position, direction);
            if (wall.a > 0.2) {
                gathered.light += wall.rgb * (faceRange.radiance / wall.a);
                gathered.nearness += 1.0;
                continue;
            }
        }
        // The content of the opposite voxel has been compared with its plane.
        float begin = VCT_GATHER_FIRST_SAMPLE;
        if (start.opposite != vec3(0.0))
            begin = max(begin, distanceOutOfVoxel(start, direction) + behindVoxel);
        ConeResult cone =
            traceCone(start.position, cascade, plane.normal, ownBelow, direction, begin, reach, spread);
        gathered.light += cone.radiance;
        gathered.sky += visibleSky(direction, gatherSolidAngle(aroundNormal.y), cone.transmittance);
        gathered.nearness += cone.nearness;
    }
    float share = 1.0 / float(cones);
    return Gathered(gathered.light * share, gathered.sky * share, gathered.nearness * share);
}

// Adds a face's light, weighted by its coverage, to the sums of its brick, which cover all faces of the block
// with the same direction (directional/light_blocks.comp).
void addToBlock(ListedFace listed, vec3 light, float coverage) {
    uint brick = brickAt(listed.voxel >> VCT_BRICK_LEVEL, listed.face >> 1, listed.face & 1);
    if (brick == 0u) return;
    uint at = blockSums(brick);
    uvec4 units = uvec4(vec4(min(light / faceRange.sums, 1.0), 1.0) * (coverage * VCT_BLOCK_UNITS) + 0.5);
    for (uint c = 0u; c < 4u; ++c)
        atomicAdd(faceIrradianceData[at + c], units[c]);
}

// Adds a step to a face's history. `known`: length of the history that counts. `stepsNow`: how many steps
// this one counts for. Outside of rounds, recent steps have more weight, because they include more bounces. A
// round is n steps with equal weights, whose mean replaces the history. The history at its first step is kept
// as `roundStart`, and each step adds (light - roundStart) / n. After n steps roundStart has cancelled out.
FaceIrradiance nextMean(FaceIrradiance before, float known, vec3 light, float nearness, float stepsNow) {
    float steps = max(known + stepsNow, lightStep.minHistory),
          share = VCT_RECENT_STEP_WEIGHT / (known + VCT_RECENT_STEP_WEIGHT);
    nearness = mix(before.nearness, nearness, share);
    if (lightStep.roundShare == 0.0 || known == 0.0)
        return FaceIrradiance(mix(before.light, light, share), steps, before.roundStart, nearness);
    vec3 roundStart = lightStep.beginsRound != 0u ? before.light : before.roundStart;
    return FaceIrradiance(max(before.light + (light - roundStart) * lightStep.roundShare, 0.0), steps,
                          roundStart, nearness);
}

void main() {
    COUNT(VCT_COUNTER_IRRADIANCE);
    if (gl_LocalInvocationIndex < sumCount) groupSums[gl_LocalInvocationIndex] = 0u;
    barrier();
    uint count = faceIrradianceData[lightSums(lightStep.frame) + VCT_SUM_CHOSEN];
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_IRRADIANCE_FACE);
        uint chosen = faceIrradianceData[lightStep.chosenFaces + i];
        uint id = chosen & ~lookedUpFlag;
        ListedFace listed = baseFace(id);
        FaceSurface surface = faceSurface(id);
        SurfacePlane plane = surface.plane;
        FaceIrradiance before = faceIrradianceAt(id);
        bool lookedUp = (chosen & lookedUpFlag) != 0u;
        float rate = turnRate(lookedUp);
        uint direction = lightStep.direction;
        // With a budget, a face's direction follows from the number of its turn. The 16 faces of a layer use
        // 16 consecutive directions in one turn, so the next turn begins behind them. The stride is 17 and
        // not 16, because an odd stride leads each face through all directions.
        if (lightStep.coneBudget > 0u)
            direction = 17u * turnOf(listed.voxel, listed.face >> 1, lookedUp).number;
        // Faces along creases are not smoothed (fill_bricks.comp), so their noise would flicker while
        // something changes. They trace more cones and have a longer history.
        float close = closeness(before.nearness);
        // A face with few turns averages fewer steps of its own, or its light would lag by many frames. It is
        // then noisier; the square root of the rate is a compromise.
        float maxSteps = lightStep.maxHistory * sqrt(rate);
        float known = min(before.steps, maxSteps * (1.0 + 2.0 * close * lightStep.smoothing));
        uint cones =
            isNearSurfaces(before) ? max(lightStep.cones, uint(VCT_MIN_CREASE_CONES)) : lightStep.cones;
        // A face without a history traces more cones, unless its coverage is so tiny that it hardly counts.
        bool isNew = known == 0.0 && surface.coverage > 0.02;
        vec3 ownBelow = ownFaces(plane.normal, surface.hasBack);
        Gathered now = gather(listed.voxel, listed.face, plane, ownBelow, direction,
                              int(isNew ? lightStep.initialCones : cones));
        // For occlusion there is no VCT_ENVIRONMENT, so `sky` is the share of the hemisphere that is open.
        vec3 light = occlusion ? vec3(now.sky) : now.light + skyLight(now.sky);
        if (!occlusion) {
            // Only the share `rate` of the faces gathers in a step, so each counts 1 / rate times in the sums
            // over all faces. Faces without a history always gather, so they count once.
            float weight = weightInSums(listed.voxel) * surface.coverage / (before.steps == 0.0 ? 1.0 : rate);
            uvec3 fromFaces = quantizeSum(now.light * weight, listed.voxel),
                  sky = quantizeSum(skyLight(now.sky) * weight, listed.voxel);
            for (uint c = 0u; c < 3u; ++c) {
                atomicAdd(groupSums[c], fromFaces[c]);
                atomicAdd(groupSums[3u + c], sky[c]);
            }
        }
        addToBlock(listed, light, surface.coverage);
        storeFaceIrradiance(id,
                            nextMean(before, known, light, now.nearness, isNew ? VCT_INITIAL_HISTORY : 1.0));
    }
    barrier();
    if (!occlusion && gl_LocalInvocationIndex < sumCount)
        atomicAdd(
            faceIrradianceData[lightSums(lightStep.frame) + VCT_SUM_FROM_FACES + gl_LocalInvocationIndex],
            groupSums[gl_LocalInvocationIndex]);
}
