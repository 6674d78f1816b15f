// Khronos' PBR neutral tone mapper, written once for the app's shader and for the PNGs of the program: "Khronos PBR
// Neutral Tone Mapper Specification" (https://github.com/KhronosGroup/ToneMapping, PBR_Neutral). Base colours up to 0.8
// come out as they are, but for the 0.04 that a dielectric's reflection of white surroundings adds to them; what is
// brighter is pressed below 1 and loses its colour by and by.
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

// Linear, from 0 on, in and out; 0 to 1 comes out.
VCT_FUNCTION vec3 neutralToneMapped(vec3 color) {
    const float reflected = 0.04;               // F90 of the specification
    const float pressedFrom = 0.8 - reflected;  // Ks
    const float desaturation = 0.15;            // Kd
    float least = min(color.x, min(color.y, color.z));
    // 6.25 = 1 / (4 reflected): the curve is smooth where it meets the constant.
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
