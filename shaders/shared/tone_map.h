// Khronos' PBR neutral tone mapper, shared by the app's shader and the command line's PNG files: "Khronos PBR
// Neutral Tone Mapper Specification" (https://github.com/KhronosGroup/ToneMapping, PBR_Neutral). Colours up
// to 0.8 only lose the 0.04 that a dielectric's reflection of white surroundings adds to them. Brighter ones
// are compressed below 1 and become less saturated.
#ifndef VCT_SHARED_TONE_MAP_H
#define VCT_SHARED_TONE_MAP_H

#include "shared/layout.h"

#ifdef __cplusplus
namespace vct::shared {
using glm::max;
using glm::min;
using glm::mix;
using glm::vec3;
#endif

// Input: linear RGB, not negative. Output: linear RGB in 0..1.
VCT_FUNCTION vec3 neutralToneMapped(vec3 color) {
    const float reflected = 0.04;               // F90 of the specification
    const float pressedFrom = 0.8 - reflected;  // Ks
    const float desaturation = 0.15;            // Kd
    float least = min(color.x, min(color.y, color.z));
    // 6.25 = 1 / (4 reflected) makes the transition to the constant smooth.
    float offset = least < 2.0 * reflected ? least - 6.25 * least * least : reflected;
    color -= vec3(offset);
    float peak = max(color.x, max(color.y, color.z));
    if (peak <= pressedFrom) return color;
    float room = 1.0 - pressedFrom;
    float pressed = 1.0 - room * room / (peak + room - pressedFrom);
    float colored = 1.0 / (desaturation * (peak - pressed) + 1.0);
    return mix(vec3(pressed), color * (pressed / peak), colored);
}

#ifdef __cplusplus
}  // namespace vct::shared
#endif
#endif
