// Light between the faces, for the injection: what a face reflects of its irradiance, and the correction of all irradiance
// at once that brings closed rooms to their balance.
#include "directional/gather_turns.glsl"

shared uint groupSums[9], groupLargestIrradiance;
vec3 balanceFactor;
uvec3 sumBefore, sumReflected, sumDirect;
float irradianceMeasured = 0.0;

vec3 sumAt(uint at) {
    return vec3(faceIrradianceData[at], faceIrradianceData[at + 1u], faceIrradianceData[at + 2u]);
}

// Light that is reflected again and again in a closed room comes to its balance slowly: each step adds one bounce, and the
// mean delays it. So all face irradiance is scaled by what the last step's sums say. Of all light that faces send, those sums
// give the share k that other faces receive; in balance the irradiance is k (direct + reflected) + sky, and a factor s on the
// irradiance before solves that for all faces together, as a coarse grid of one cell does in a multigrid solver. The mean
// of that step has moved by its own share already, and by as much less where faces take turns; here it comes as near to the
// balance as `energyCorrection` says: half the way while the light is found, and in rounds no more than the mean does, as the
// directions of one step favour some light.
vec3 globalEnergyCorrection() {
    uint sums = lightSums(lightStep.frame + 2u);  // of the step before
    vec3 before = sumAt(sums + VCT_SUM_BEFORE);
    vec3 fromFaces = sumAt(sums + VCT_SUM_FROM_FACES);
    vec3 reflected = sumAt(sums + VCT_SUM_REFLECTED);
    vec3 direct = sumAt(sums + VCT_SUM_DIRECT);
    vec3 sky = sumAt(sums + VCT_SUM_SKY);
    vec3 share = fromFaces / max(direct + reflected, 1.0);
    // A room where nothing is absorbed would have no bound.
    vec3 left = max(before - share * reflected, (1.0 - frame.largestBounceShare) * before);
    vec3 balance = clamp((share * direct + sky) / max(left, 1.0), 0.25, 4.0);
    vec3 found = clamp((fromFaces + sky) / max(before, 1.0), 0.25, 4.0);
    vec3 factor = (1.0 + lightStep.energyCorrection * (balance - 1.0)) / (1.0 + lightStep.amplitude * turnRate(true) * (found - 1.0));
    return mix(vec3(1.0), clamp(factor, 0.5, 4.0), greaterThan(before, vec3(64.0)));
}

// Every invocation begins with it.
void beginBalance() {
    if (gl_LocalInvocationIndex < 9u) groupSums[gl_LocalInvocationIndex] = 0u;
    if (gl_LocalInvocationIndex == 0u) groupLargestIrradiance = 0u;
    barrier();
    sumBefore = sumReflected = sumDirect = uvec3(0u);
    balanceFactor = lightStep.amplitude > 0.0 ? globalEnergyCorrection() : vec3(1.0);
}

// A face's radiance with what it reflects of its irradiance. `direct`: without; both relative to E/pi.
vec3 withBounces(uint id, float coverage, vec3 direct, vec3 albedo) {
    FaceIrradiance mean = faceIrradianceAt(id);
    mean.light = min(mean.light * balanceFactor, largestLight);
    mean.atStart *= balanceFactor;
    storeFaceIrradiance(id, mean);
    irradianceMeasured = largerOf(irradianceMeasured, mean.light);
    // The gain makes up for what cones lose. No face reflects more than it receives.
    vec3 reflecting = min(lightStep.bounceGain * albedo, coverage);
    vec3 own = direct + reflecting * emitterIrradiance(id);
    sumBefore += inSumUnits(coverage * mean.light);
    sumReflected += inSumUnits(reflecting * mean.light);
    sumDirect += inSumUnits(min(own, faceRange.radiance));
    return own + reflecting * mean.light;
}

// Every invocation ends with it.
void endBalance() {
    for (int c = 0; c < 3; ++c) {
        atomicAdd(groupSums[VCT_SUM_BEFORE + uint(c)], sumBefore[c]);
        atomicAdd(groupSums[VCT_SUM_REFLECTED + uint(c)], sumReflected[c]);
        atomicAdd(groupSums[VCT_SUM_DIRECT + uint(c)], sumDirect[c]);
    }
    atomicMax(groupLargestIrradiance, floatBitsToUint(irradianceMeasured));
    barrier();
    if (gl_LocalInvocationIndex == 0u) atomicMax(largestIrradiance, groupLargestIrradiance);
    if (gl_LocalInvocationIndex < 9u)
        atomicAdd(faceIrradianceData[lightSums(lightStep.frame) + gl_LocalInvocationIndex],
                  groupSums[gl_LocalInvocationIndex]);
}
