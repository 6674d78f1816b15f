// Reflected irradiance for the injection of light, and a global correction of all irradiance, which makes the
// bounces in closed rooms converge faster.
#include "directional/gather_turns.glsl"
#include "directional/light_sums.glsl"

shared uint groupSums[9], groupLargest;
vec3 balanceFactor;
uvec3 sumBefore, sumReflected, sumDirect;
float largestMeasured =
    0.0;  // light of a face, for the range of the next step (directional/choose_range.comp)

// NaN is ignored, because it fails the comparison.
void measure(vec3 light) {
    float largest = max(light.r, max(light.g, light.b));
    if (largest > largestMeasured) largestMeasured = min(largest, maxStoredLight);
}

vec3 sumAt(uint at) {
    return vec3(faceIrradianceData[at], faceIrradianceData[at + 1u], faceIrradianceData[at + 2u]);
}

// A factor on all face irradiance that brings it closer to the energy balance. Without it, light in a closed
// room converges slowly: each step adds one bounce, and the history delays it.
//
// The sums of the last step give the share k of the light that faces send and other faces receive. In
// balance,
//
//     irradiance = k (direct + reflected) + sky.
//
// One factor on the irradiance solves this for the sum over all faces, as a grid of one cell does in a
// multigrid solver. The histories have already moved by the weight of that step, less if faces take turns.
// The correction covers the share lightStep.energyCorrection of the rest: half in the first steps, and in
// rounds no more than the step's weight, because the directions of a single step favour some of the light.
vec3 globalEnergyCorrection() {
    uint sums = lightSums(lightStep.frame + 2u);  // the previous step's
    vec3 before = sumAt(sums + VCT_SUM_BEFORE);
    vec3 fromFaces = sumAt(sums + VCT_SUM_FROM_FACES);
    vec3 reflected = sumAt(sums + VCT_SUM_REFLECTED);
    vec3 direct = sumAt(sums + VCT_SUM_DIRECT);
    vec3 sky = sumAt(sums + VCT_SUM_SKY);
    vec3 share = fromFaces / max(direct + reflected, 1.0);
    // The light in a room without absorption would grow without bound.
    vec3 left = max(before - share * reflected, (1.0 - frame.largestBounceShare) * before);
    vec3 balance = clamp((share * direct + sky) / max(left, 1.0), 0.25, 4.0);
    vec3 found = clamp((fromFaces + sky) / max(before, 1.0), 0.25, 4.0);
    vec3 factor = (1.0 + lightStep.energyCorrection * (balance - 1.0)) /
                  (1.0 + lightStep.previousStepWeight * turnRate(true) * (found - 1.0));
    return mix(vec3(1.0), clamp(factor, 0.5, 4.0), greaterThan(before, vec3(64.0)));
}

// Every invocation calls this first.
void beginBalance() {
    if (gl_LocalInvocationIndex < 9u) groupSums[gl_LocalInvocationIndex] = 0u;
    if (gl_LocalInvocationIndex == 0u) groupLargest = 0u;
    barrier();
    sumBefore = sumReflected = sumDirect = uvec3(0u);
    balanceFactor = lightStep.previousStepWeight > 0.0 ? globalEnergyCorrection() : vec3(1.0);
}

// A face's radiance: `direct` and the reflected irradiance, both relative to E/pi. Also applies the global
// correction to the face's history, and adds to the sums, where the face stands for the `period` steps from
// one injection to the next.
vec3 addBounces(uint id, ivec3 voxel, float period, float coverage, vec3 direct, vec3 albedo) {
    FaceIrradiance mean = faceIrradianceAt(id);
    mean.light.rgb = min(mean.light.rgb * balanceFactor, maxStoredLight);
    mean.roundStart.rgb *= balanceFactor;
    storeFaceIrradiance(id, mean);
    vec3 light = mean.light.rgb;
    vec3 own = direct + lightStep.bounces * albedo * emitterIrradiance(id);
    float weight = period * coverage * weightInSums(voxel);
    sumBefore += quantizeSum(weight * light, voxel);
    sumReflected += quantizeSum(weight * albedo * light, voxel);
    sumDirect += quantizeSum(weight * min(own, lightRange), voxel);
    vec3 radiance = own + lightStep.bounces * albedo * light;
    measure(light);
    measure(radiance);
    return radiance;
}

// Every invocation calls this last.
void endBalance() {
    for (int c = 0; c < 3; ++c) {
        atomicAdd(groupSums[VCT_SUM_BEFORE + uint(c)], sumBefore[c]);
        atomicAdd(groupSums[VCT_SUM_REFLECTED + uint(c)], sumReflected[c]);
        atomicAdd(groupSums[VCT_SUM_DIRECT + uint(c)], sumDirect[c]);
    }
    atomicMax(groupLargest, floatBitsToUint(largestMeasured));
    barrier();
    if (gl_LocalInvocationIndex == 0u) atomicMax(largestLight, groupLargest);
    if (gl_LocalInvocationIndex < 9u)
        atomicAdd(faceIrradianceData[lightSums(lightStep.frame) + gl_LocalInvocationIndex],
                  groupSums[gl_LocalInvocationIndex]);
}
