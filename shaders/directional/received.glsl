// What each face of the base level has received so far: a mean over steps, in the order of the list of faces. Light is
// relative to E/pi over frame.radianceRange. Before them, sums over all faces of what the last steps found; behind them, sums over
// those of each block.
#include "shared/layout.h"

layout(std140, binding = VCT_UBO_LIGHT) uniform LightBlock {
    LightStep lightStep;
};
layout(std430, binding = VCT_SSBO_RECEIVED) buffer ReceivedBlock {
    uint received[];
};

struct Received {
    vec3 light;    // of occlusion: how open the surroundings are, three times
    float steps;   // how many the mean remembers; 0: there is none
    vec3 atStart;  // `light` when the present round began
    float nearness;  // mean of 1 / distance of what is around, in voxels
};

// Words of a face.
#ifdef VCT_EMITTERS
#define VCT_RECEIVED_WORDS 6u
#else
#define VCT_RECEIVED_WORDS 4u
#endif
uint receivedIndex(uint face) {
    return VCT_LIGHT_HEADER + VCT_RECEIVED_WORDS * face;
}

Received receivedOf(uint face) {
    uint at = receivedIndex(face);
    vec2 last = unpackHalf2x16(received[at + 1u]), lastAtStart = unpackHalf2x16(received[at + 3u]);
    return Received(vec3(unpackHalf2x16(received[at]), last.x), last.y, vec3(unpackHalf2x16(received[at + 2u]), lastAtStart.x),
                    lastAtStart.y);
}
float stepsOf(uint face) {
    return unpackHalf2x16(received[receivedIndex(face) + 1u]).y;
}

void storeReceived(uint face, Received value) {
    uint at = receivedIndex(face);
    received[at] = packHalf2x16(value.light.rg);
    received[at + 1u] = packHalf2x16(vec2(value.light.b, value.steps));
    received[at + 2u] = packHalf2x16(value.atStart.rg);
    received[at + 3u] = packHalf2x16(vec2(value.atStart.b, value.nearness));
}

// And what it receives of lamps (directional/emitters.comp), which is no mean: the same in all steps.
#ifdef VCT_EMITTERS
vec3 fromEmitters(uint face) {
    uint at = receivedIndex(face) + 4u;
    return vec3(unpackHalf2x16(received[at]), unpackHalf2x16(received[at + 1u]).x);
}
void storeFromEmitters(uint face, vec3 light) {
    uint at = receivedIndex(face) + 4u;
    received[at] = packHalf2x16(light.rg);
    received[at + 1u] = packHalf2x16(vec2(light.b, 0.0));
}
#else
vec3 fromEmitters(uint face) {
    return vec3(0.0);
}
#endif

// The sums of a step, each weighted by coverage: what the faces received before it, what they send on of that, and what they
// send of their own, three words each; what they received in it from other faces; and what they saw of the sky
// (directional/sky_light.glsl), one word or three.
#define VCT_SUM_BEFORE 0u
#define VCT_SUM_REFLECTED 3u
#define VCT_SUM_DIRECT 6u
#define VCT_SUM_RECEIVED 9u
#define VCT_SUM_SKY 12u

uint lightSums(uint which) {
    return which % 3u * VCT_LIGHT_SUMS;
}

// And behind the faces, of each brick what its block's faces received in the step, and their coverage.
uint blockSums(uint brick) {
    uvec3 place = uvec3(unpackBrick(brick));
    uint along = lightStep.bricksAlong;
    return lightStep.blockSums + 4u * (place.x + along * (place.y + along * place.z));
}
