// The irradiance of each face of the base level: its history, a mean over steps, by the face's id. Light is relative to E/pi.
// Before the faces come sums over all of them of what the last steps found, behind them sums over the faces of each block.
#include "directional/face_range.glsl"

layout(std140, binding = VCT_UBO_LIGHT) uniform LightBlock {
    LightStep lightStep;
};
layout(std430, binding = VCT_SSBO_FACE_IRRADIANCE) buffer FaceIrradianceBlock {
    uint faceIrradianceData[];
};

struct FaceIrradiance {
    vec3 light;      // the history's mean; for ambient occlusion the ambient visibility, three times
    float steps;     // history length; 0: there is none
    vec3 atStart;    // `light` when the present round began
    float nearness;  // mean of 1 / distance of what is around, in voxels
};

// Words of a face.
#ifdef VCT_EMITTERS
#define VCT_IRRADIANCE_WORDS 6u
#else
#define VCT_IRRADIANCE_WORDS 4u
#endif
uint irradianceIndex(uint id) {
    return VCT_LIGHT_HEADER + VCT_IRRADIANCE_WORDS * id;
}

FaceIrradiance faceIrradianceAt(uint id) {
    uint at = irradianceIndex(id);
    vec2 last = unpackHalf2x16(faceIrradianceData[at + 1u]), lastAtStart = unpackHalf2x16(faceIrradianceData[at + 3u]);
    return FaceIrradiance(vec3(unpackHalf2x16(faceIrradianceData[at]), last.x), last.y,
                          vec3(unpackHalf2x16(faceIrradianceData[at + 2u]), lastAtStart.x), lastAtStart.y);
}
float historyLength(uint id) {
    return unpackHalf2x16(faceIrradianceData[irradianceIndex(id) + 1u]).y;
}

// Brighter light is cut off: halves end at 65504.
const float largestLight = 6e4;

void storeFaceIrradiance(uint id, FaceIrradiance value) {
    uint at = irradianceIndex(id);
    vec3 light = min(value.light, largestLight), atStart = min(value.atStart, largestLight);
    faceIrradianceData[at] = packHalf2x16(light.rg);
    faceIrradianceData[at + 1u] = packHalf2x16(vec2(light.b, value.steps));
    faceIrradianceData[at + 2u] = packHalf2x16(atStart.rg);
    faceIrradianceData[at + 3u] = packHalf2x16(vec2(atStart.b, value.nearness));
}

// Irradiance changes no faster from place to place than what sends it is near (Ward, Rubinstein and Clear 1988).
// Closeness is 1 where that is a voxel away, as along creases, and 0 from four voxels on.
float closeness(float nearness) {
    return 1.0 - clamp((1.0 / max(nearness, 1e-3) - 1.0) / 3.0, 0.0, 1.0);
}
bool isNearSurfaces(FaceIrradiance mean) {
    return closeness(mean.nearness) > 0.5;
}

// The place of a face among the 16 of a flat block, row by row across its axis.
int indexInBlock(ivec3 voxel, int axis) {
    ivec2 across = axis == 0 ? voxel.yz : axis == 1 ? voxel.zx : voxel.xy;
    return (across.x & 3) + 4 * (across.y & 3);
}

// What a face receives of the compact emitters (directional/emitters.comp) is no mean: it is the same in all steps.
#ifdef VCT_EMITTERS
vec3 emitterIrradiance(uint id) {
    uint at = irradianceIndex(id) + 4u;
    return vec3(unpackHalf2x16(faceIrradianceData[at]), unpackHalf2x16(faceIrradianceData[at + 1u]).x);
}
void storeEmitterIrradiance(uint id, vec3 light) {
    uint at = irradianceIndex(id) + 4u;
    light = min(light, largestLight);
    faceIrradianceData[at] = packHalf2x16(light.rg);
    faceIrradianceData[at + 1u] = packHalf2x16(vec2(light.b, 0.0));
}
#else
vec3 emitterIrradiance(uint id) {
    return vec3(0.0);
}
void storeEmitterIrradiance(uint id, vec3 light) {}
#endif

// The sums of a step, each weighted by coverage, three words each: irradiance before it, what faces reflect of that, and what
// they send of their own; what they received in it from other faces, and from the sky.
#define VCT_SUM_BEFORE 0u
#define VCT_SUM_REFLECTED 3u
#define VCT_SUM_DIRECT 6u
#define VCT_SUM_FROM_FACES 9u
#define VCT_SUM_SKY 12u

// A value in fixed point, for these sums: integers add up to the same in any order. The bound keeps a product in 32 bits.
uvec3 inSumUnits(vec3 value) {
    return uvec3(min(value / faceRange.sums, 64.0) * lightStep.sumUnits + 0.5);
}

uint lightSums(uint step) {
    return step % 3u * VCT_LIGHT_SUMS;
}

// Behind the faces: what the faces of a brick's block received in the step, and their coverage.
uint blockSums(uint brick) {
    uvec3 place = uvec3(unpackBrick(brick));
    uint along = lightStep.bricksAlong;
    return lightStep.blockSums + 4u * (place.x + along * (place.y + along * place.z));
}
