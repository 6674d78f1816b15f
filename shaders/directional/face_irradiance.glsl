// The irradiance of each face of level 0, by the face's id, as a running mean over its steps. It is relative
// to E, the irradiance of a surface that faces the sun. The buffer has, in this order: sums over all faces
// for the last three steps, the histories of the faces, the sums of the blocks, and the list of the faces
// that gather.
#include "directional/light_step.glsl"

layout(std430, binding = VCT_SSBO_FACE_IRRADIANCE) buffer FaceIrradianceBlock {
    uint faceIrradianceData[];
};

struct FaceIrradiance {
    vec4 light;       // mean irradiance; a: ambient visibility
    float steps;      // history length; 0: no history
    vec4 roundStart;  // `light` at the beginning of the round (directional/gather.comp: nextMean())
    float nearness;   // mean of 1 / distance to the surrounding surfaces, in voxels
};
// Words per face.
#ifdef VCT_EMITTERS
#define VCT_IRRADIANCE_WORDS 7u
#else
#define VCT_IRRADIANCE_WORDS 5u
#endif
uint irradianceIndex(uint id) {
    return VCT_LIGHT_HEADER + VCT_IRRADIANCE_WORDS * id;
}

FaceIrradiance faceIrradianceAt(uint id) {
    uint at = irradianceIndex(id);
    vec2 blueAndSteps = unpackHalf2x16(faceIrradianceData[at + 1u]);
    vec2 startBlueAndNearness = unpackHalf2x16(faceIrradianceData[at + 3u]);
    vec2 visibility = unpackHalf2x16(faceIrradianceData[at + 4u]);
    return FaceIrradiance(
        vec4(unpackHalf2x16(faceIrradianceData[at]), blueAndSteps.x, visibility.x), blueAndSteps.y,
        vec4(unpackHalf2x16(faceIrradianceData[at + 2u]), startBlueAndNearness.x, visibility.y),
        startBlueAndNearness.y);
}
float historyLength(uint id) {
    return unpackHalf2x16(faceIrradianceData[irradianceIndex(id) + 1u]).y;
}

// Upper limit of stored light. The largest half float is 65504.
const float maxStoredLight = 6e4;

void storeFaceIrradiance(uint id, FaceIrradiance value) {
    uint at = irradianceIndex(id);
    vec4 light = min(value.light, maxStoredLight), roundStart = min(value.roundStart, maxStoredLight);
    faceIrradianceData[at] = packHalf2x16(light.rg);
    faceIrradianceData[at + 1u] = packHalf2x16(vec2(light.b, value.steps));
    faceIrradianceData[at + 2u] = packHalf2x16(roundStart.rg);
    faceIrradianceData[at + 3u] = packHalf2x16(vec2(roundStart.b, value.nearness));
    faceIrradianceData[at + 4u] = packHalf2x16(vec2(light.a, roundStart.a));
}

// The nearer the surrounding surfaces are, the faster irradiance varies along a surface (Ward, Rubinstein and
// Clear 1988). Closeness is 1 if their harmonic mean distance is at most one voxel, as along creases, and
// falls to 0 at four voxels.
float closeness(float nearness) {
    return 1.0 - clamp((1.0 / max(nearness, 1e-3) - 1.0) / 3.0, 0.0, 1.0);
}
bool isNearSurfaces(FaceIrradiance mean) {
    return closeness(mean.nearness) > 0.5;
}

// The index (0 to 15) of a face in its layer: the 4 x 4 faces of a block that have the same position along
// the face's axis.
int indexInBlock(ivec3 voxel, int axis) {
    ivec2 across = axis == 0 ? voxel.yz : axis == 1 ? voxel.zx : voxel.xy;
    return (across.x & 3) + 4 * (across.y & 3);
}

// Irradiance by the compact emitters (directional/emitters.comp). It needs no history, because it has no
// noise.
#ifdef VCT_EMITTERS
vec3 emitterIrradiance(uint id) {
    uint at = irradianceIndex(id) + 5u;
    return vec3(unpackHalf2x16(faceIrradianceData[at]), unpackHalf2x16(faceIrradianceData[at + 1u]).x);
}
void storeEmitterIrradiance(uint id, vec3 light) {
    uint at = irradianceIndex(id) + 5u;
    light = min(light, maxStoredLight);
    faceIrradianceData[at] = packHalf2x16(light.rg);
    faceIrradianceData[at + 1u] = packHalf2x16(vec2(light.b, 0.0));
}
#else
vec3 emitterIrradiance(uint id) {
    return vec3(0.0);
}
void storeEmitterIrradiance(uint id, vec3 light) {}
#endif

// The position of a step's sums. There are three: of the previous step (step + 2, modulo 3), of this step,
// and of the next step (step + 1), which are being cleared.
uint lightSums(uint step) {
    return step % 3u * VCT_LIGHT_SUMS;
}

// The position of the sums over a brick's faces in the step: irradiance in three words, and coverage.
uint blockSums(uint brick) {
    uvec3 place = uvec3(unpackBrick(brick));
    uint along = lightStep.bricksAlong;
    return lightStep.blockSums + 4u * (place.x + along * (place.y + along * place.z));
}
