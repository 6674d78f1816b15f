// One step of the gather: each face of the base level traces a few cones from the middle of its surface, adds what they meet
// to its history, and writes the history's mean into its brick. VCT_GATHER_OCCLUSION (true or false): it gathers ambient
// visibility in place of light.
#define VCT_CONE_COUNTER VCT_COUNTER_IRRADIANCE_STEP
#include "directional/face_sums.glsl"
#include "directional/cones.glsl"
#include "directional/irradiance.glsl"
#include "directional/face_irradiance.glsl"
#include "directional/sky_light.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba16f, binding = VCT_IMAGE_IRRADIANCE) writeonly uniform mediump image3D irradianceTexels;
layout(binding = VCT_TEX_BLOCK_LIGHT) uniform mediump sampler3D blockLight;

const bool occlusion = VCT_GATHER_OCCLUSION;

const uint sums = 6u;
shared uint groupSums[sums];

struct Gathered {
    vec3 light;
    SkySeen sky;
    float nearness;  // mean of 1 / distance of what the cones meet, in voxels
};

// Direction `i` of VCT_GATHER_DIRECTIONS, a power of two, around a normal along +y, with its cosine in y: a Hammersley set of
// the hemisphere weighted by the cosine.
vec3 gatherDirection(int i) {
    float height = float(bitfieldReverse(uint(i))) / 4294967296.0 + 0.5 / float(VCT_GATHER_DIRECTIONS);
    float azimuth = 6.2831853 / float(VCT_GATHER_DIRECTIONS) * float(i);
    return vec3(sqrt(height) * cos(azimuth), sqrt(1.0 - height), sqrt(height) * sin(azimuth));
}

// The cones of a step are the next of the set of directions; the 16 faces of a flat block look into 16 in a row. From one to
// the next it is the golden section of a turn, nearly: any few in a row are spread over the hemisphere.
Gathered gather(ivec3 voxel, int axis, SurfacePlane plane, vec3 ownBelow, int cones) {
    const int golden = (VCT_GATHER_DIRECTIONS * 618 / 1000) | 1;
    vec3 start = vec3(voxel) + 0.5 + plane.normal * (plane.offset + VCT_GATHER_START);
    ivec2 across = axis == 0 ? voxel.yz : axis == 1 ? voxel.zx : voxel.xy;
    ivec2 inBlock = ivec2(across.x & 3, across.y & 3);
    int first = int(lightStep.direction) + inBlock.x + 4 * inBlock.y;
    float reach = (occlusion ? frame.aoDistance : 2.0) * float(frame.gridSide);
    Gathered gathered = Gathered(vec3(0.0), SkySeen(0.0), 0.0);
    for (int i = first; i < first + cones; ++i) {
        COUNT(VCT_COUNTER_IRRADIANCE_CONE);
        vec3 aroundNormal = gatherDirection(i * golden & (VCT_GATHER_DIRECTIONS - 1));
        vec3 direction = frameAround(plane.normal) * aroundNormal;
        // From half a level less to half a level more, evenly; the same for a direction of a face in each round.
        int chance = (i & (VCT_GATHER_DIRECTIONS - 1)) * 49471 + 4096 * (inBlock.x + 4 * inBlock.y);
        float spread = exp2(float(chance & 65535) / 65536.0 - 0.5);
        ConeResult cone = traceCone(start, plane.normal, ownBelow, direction, reach, spread);
        gathered.light += cone.radiance;
        // The directions share the hemisphere, weighted by the cosine.
        float solidAngle = 3.1415927 / (float(VCT_GATHER_DIRECTIONS) * aroundNormal.y);
        gathered.sky += skySeen(direction, solidAngle, cone.transmittance);
        gathered.nearness += cone.nearness;
    }
    float share = 1.0 / float(cones);
    return Gathered(gathered.light * share, gathered.sky * share, gathered.nearness * share);
}

// Into its own brick, and those of neighbours which hold it for their filter.
void storeInBricks(ListedFace listed, vec4 texel) {
    ivec3 block = listed.voxel >> VCT_BRICK_LEVEL;
    ivec3 place = listed.voxel - block * VCT_BRICK_SIDE;
    ivec3 aside = ivec3(equal(place, ivec3(VCT_BRICK_SIDE - 1))) - ivec3(equal(place, ivec3(0)));
    // A bit of i for each axis along which a neighbour holds it.
    ivec3 edge = abs(aside);
    ivec3 bit = ivec3(0, edge.x, edge.x + edge.y);
    for (int i = 0; i < 1 << (bit.z + edge.z); ++i) {
        COUNT(VCT_COUNTER_IRRADIANCE_BRICK);
        ivec3 chosen = ivec3(i) >> bit & edge;
        ivec3 other = block + chosen * aside;
        if (other != clamp(other, ivec3(0), ivec3((frame.gridSide >> VCT_BRICK_LEVEL) - 1))) continue;
        uint brick = brickAt(other, listed.face >> 1, listed.face & 1);
        if (brick == 0u) continue;
        ivec3 inBrick = listed.voxel - other * VCT_BRICK_SIDE + 1;
        imageStore(irradianceTexels, unpackBrick(brick) * VCT_BRICK_TEXELS + inBrick, texel);
    }
}

// Of all faces of its block that look the same way: directional/light_blocks.comp.
void addToBlock(ListedFace listed, vec3 light, float coverage) {
    uint brick = brickAt(listed.voxel >> VCT_BRICK_LEVEL, listed.face >> 1, listed.face & 1);
    if (brick == 0u) return;
    uint at = blockSums(brick);
    uvec4 units = uvec4(vec4(min(light / faceRange.sums, 1.0), 1.0) * (coverage * VCT_BLOCK_UNITS) + 0.5);
    for (uint c = 0u; c < 4u; ++c)
        atomicAdd(faceIrradianceData[at + c], units[c]);
}

// Towards the final value in two ways. At first later steps weigh more, as they know more bounces: the first ones fade with
// a power of the number of steps. Then, in rounds, all directions weigh the same: by and by the mean of a round takes the
// place of what was there when it began.
FaceIrradiance nextMean(FaceIrradiance before, float known, vec3 light, float nearness, float stepsNow) {
    float steps = max(known + stepsNow, lightStep.leastHistory), share = VCT_FORGETTING / (known + VCT_FORGETTING);
    nearness = mix(before.nearness, nearness, share);
    if (lightStep.shareInRound == 0.0 || known == 0.0)
        return FaceIrradiance(mix(before.light, light, share), steps, before.atStart, nearness);
    vec3 atStart = lightStep.beginsRound != 0u ? before.light : before.atStart;
    return FaceIrradiance(max(before.light + (light - atStart) * lightStep.shareInRound, 0.0), steps, atStart, nearness);
}

// What is received changes no faster from place to place than what sends it is near (Ward, Rubinstein and Clear 1988).
// 1 where that is a voxel away, as along creases, 0 from four voxels on.
float closeness(float nearness) {
    return 1.0 - clamp((1.0 / max(nearness, 1e-3) - 1.0) / 3.0, 0.0, 1.0);
}

// What is remembered of a face is that of few cones while things change, but far from all a face takes the mean of its
// block's faces and of those around, which have looked into many directions together.
vec3 smoothed(vec3 light, float nearness, ListedFace listed, vec3 inVoxels) {
    float weight = lightStep.smoothing * (1.0 - closeness(nearness));
    // No texel of another direction's faces may leak in.
    float margin = 0.5 * float(VCT_BRICK_SIDE) / float(frame.gridSide);
    vec3 position = clamp(inVoxels / float(frame.gridSide), margin, 1.0 - margin);
    vec4 around = textureLod(blockLight, (position + vec3(listed.face >> 1, listed.face & 1, 0)) * blockSize, 0.0);
    return weight > 0.0 && around.a > 0.0 ? mix(light, around.rgb / around.a, weight) : light;
}

void main() {
    COUNT(VCT_COUNTER_IRRADIANCE);
    if (gl_LocalInvocationIndex < sums) groupSums[gl_LocalInvocationIndex] = 0u;
    barrier();
    uint count = baseFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_IRRADIANCE_FACE);
        uint id = baseFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        FaceSurface surface = faceSurface(id);
        SurfacePlane plane = surface.plane;
        FaceIrradiance before = faceIrradianceAt(id);
        // Nothing smooths a face along a crease: while things change it would differ from the next one by chance, and that
        // crawls. It traces more cones, and its history is longer.
        float close = closeness(before.nearness);
        float known = min(before.steps, lightStep.memory * (1.0 + 2.0 * close * lightStep.smoothing));
        uint cones = close > 0.5 ? max(lightStep.cones, uint(VCT_CONES_OF_CREASES)) : lightStep.cones;
        // A face without a history traces more cones, unless there is hardly anything of it.
        bool isNew = known == 0.0 && surface.coverage > 0.02;
        vec3 ownBelow = ownFaces(plane.normal, surface.hasBack);
        Gathered now = gather(listed.voxel, listed.face >> 1, plane, ownBelow, int(isNew ? lightStep.conesOfNew : cones));
        vec3 light = occlusion ? vec3(now.sky) : now.light + skyLight(now.sky);
        if (!occlusion) {
            uvec3 fromFaces = inSumUnits(now.light * surface.coverage), sky = inSumUnits(skyLight(now.sky) * surface.coverage);
            for (uint c = 0u; c < 3u; ++c) {
                atomicAdd(groupSums[c], fromFaces[c]);
                atomicAdd(groupSums[3u + c], sky[c]);
            }
        }
        addToBlock(listed, light, surface.coverage);
        FaceIrradiance mean = nextMean(before, known, light, now.nearness, isNew ? VCT_STEPS_OF_NEW : 1.0);
        storeFaceIrradiance(id, mean);
        vec3 inVoxels = vec3(listed.voxel) + 0.5 + plane.normal * plane.offset;
        vec3 all = min(smoothed(mean.light, mean.nearness, listed, inVoxels) + emitterIrradiance(id), largestLight);
        storeInBricks(listed, vec4(all, 1.0) * surface.coverage);
    }
    barrier();
    if (!occlusion && gl_LocalInvocationIndex < sums)
        atomicAdd(faceIrradianceData[lightSums(lightStep.frame) + VCT_SUM_RECEIVED + gl_LocalInvocationIndex],
                  groupSums[gl_LocalInvocationIndex]);
}
