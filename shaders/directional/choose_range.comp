// Chooses the ranges of a light step from what the last injection measured. Faces store radiance in 8 bits,
// so the range is little more than the largest radiance. It is a power of 2^(1/4) times the largest emission,
// so that a picture scales with it, and is kept while it fits, so that noise does not change it and a static
// scene converges to one range.
#include "shared/commands.glsl"
#include "shared/counters.glsl"
#include "shared/frame.glsl"

layout(local_size_x = 1) in;
layout(location = VCT_UNIFORM_COMPLETE) uniform uint complete;
layout(std430, binding = VCT_SSBO_FACE_RANGE) buffer FaceRangeBlock {
    FaceRange faceRange;
};

const float headroom = 1.0625;
// A range shrinks if it is more than this factor too large: more than two steps of 2^(1/4). If the last
// injection left faces out, it only grows.
const float maxExcess = 1.5;
const float smallest = 1e-7;

void main() {
    COUNT(VCT_COUNTER_CHOOSE_RANGE);
    float largest = uintBitsToFloat(largestRadiance), before = faceRange.radiance;
    if (largest > 0.0) {
        float steps = ceil(4.0 * log2(headroom * max(largest, smallest) / frame.emissionRange));
        float fitting = frame.emissionRange * exp2(steps / 4.0);
        if (faceRange.radiance < fitting || complete != 0u && faceRange.radiance > maxExcess * fitting)
            faceRange.radiance = fitting;
    } else if (faceRange.radiance == 0.0) {
        // Nothing has been measured yet. A surface that the sky lights is at most as bright as the sky.
        faceRange.radiance = max(frame.largestSky, smallest);
    }
    faceRange.changed = faceRange.radiance == before ? 0.0 : 1.0;
    faceRange.sums = max(max(faceRange.radiance, frame.largestSky), uintBitsToFloat(largestIrradiance));
    largestRadiance = 0u;
    largestIrradiance = 0u;
}
