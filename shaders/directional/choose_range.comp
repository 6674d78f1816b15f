// Chooses the range of the integer sums of a light step: the largest light of a face in the last injection.
#include "shared/commands.glsl"
#include "shared/counters.glsl"
#include "shared/frame.glsl"

layout(local_size_x = 1) in;

void main() {
    COUNT(VCT_COUNTER_CHOOSE_RANGE);
    const float smallest = 1e-7;
    float largest = uintBitsToFloat(largestLight);
    // Before the first injection, a surface is as bright as in the sun, or as the sky or an emitter.
    if (largest == 0.0) largest = lightRange == 0.0 ? max(frame.emissionRange, 1.0) : smallest;
    lightRange = max(largest, max(frame.largestSky, smallest));
    largestLight = 0u;
}
