// Tone mappers, shared by the app's shader and the command line's PNG files. Input of each: linear RGB with
// the primaries of sRGB, not negative. Output: linear RGB in 0..1.
#ifndef VCT_SHARED_TONE_MAP_H
#define VCT_SHARED_TONE_MAP_H

#include "shared/layout.h"

#ifdef __cplusplus
namespace vct::shared {
using glm::clamp;
using glm::log2;
using glm::mat3;
using glm::max;
using glm::min;
using glm::mix;
using glm::pow;
using glm::vec3;
#endif

// "Khronos PBR Neutral Tone Mapper Specification" (https://github.com/KhronosGroup/ToneMapping, PBR_Neutral).
// Colours up to 0.8 only lose the 0.04 that a dielectric's reflection of white surroundings adds to them.
// Brighter ones are compressed below 1 and become less saturated.
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

// AgX (Troy Sobotka 2022) as in Blender, with its curve as the polynomial of B. Wrensch ("Minimal AgX
// Implementation"). Bright colours turn white gradually and keep their hue. It shows a range of 16.5 stops,
// so pictures have little contrast.
VCT_FUNCTION vec3 agxToneMapped(vec3 color) {
    // Columns of the matrices from sRGB to Rec. 2020 and to AgX's own primaries, and back.
    const mat3 rec2020FromSrgb =
        mat3(vec3(0.6274, 0.0691, 0.0164), vec3(0.3293, 0.9195, 0.0880), vec3(0.0433, 0.0113, 0.8956));
    const mat3 srgbFromRec2020 =
        mat3(vec3(1.6605, -0.1246, -0.0182), vec3(-0.5876, 1.1329, -0.1006), vec3(-0.0728, -0.0083, 1.1187));
    const mat3 inset =
        mat3(vec3(0.856627153, 0.137318973, 0.111898213), vec3(0.095121241, 0.761241991, 0.076799419),
             vec3(0.048251606, 0.101439036, 0.811302368));
    const mat3 outset =
        mat3(vec3(1.127100582, -0.141329763, -0.141329763), vec3(-0.110606643, 1.157823702, -0.110606643),
             vec3(-0.016493939, -0.016493939, 1.251936407));
    const float leastStops = -12.47393, mostStops = 4.026069;  // -10 and +6.5 around middle grey, 0.18
    vec3 stops = log2(max(inset * (rec2020FromSrgb * color), vec3(1e-10)));
    vec3 x = clamp((stops - vec3(leastStops)) / (mostStops - leastStops), vec3(0.0), vec3(1.0));
    vec3 x2 = x * x, x4 = x2 * x2;
    const float c6 = 15.5, c5 = -40.14, c4 = 31.96, c3 = -6.868, c2 = 0.4298, c1 = 0.1191, c0 = -0.00232;
    vec3 shown = c6 * x4 * x2 + c5 * x4 * x + c4 * x4 + c3 * x2 * x + c2 * x2 + c1 * x + vec3(c0);
    shown = pow(max(outset * shown, vec3(0.0)), vec3(2.2));
    return clamp(srgbFromRec2020 * shown, vec3(0.0), vec3(1.0));
}

// The film look of the Academy Color Encoding System, as the fit by S. Hill (BakingLab, ACES.hlsl) to its
// reference and output transforms. It has much contrast, darkens middle grey and turns bright colours white.
VCT_FUNCTION vec3 acesToneMapped(vec3 color) {
    const mat3 rrtFromSrgb = mat3(vec3(0.59719, 0.07600, 0.02840), vec3(0.35458, 0.90834, 0.13383),
                                  vec3(0.04823, 0.01566, 0.83777));
    const mat3 srgbFromOdt = mat3(vec3(1.60475, -0.10208, -0.00327), vec3(-0.53108, 1.10813, -0.07276),
                                  vec3(-0.07367, -0.00605, 1.07602));
    const float a1 = 0.0245786, a0 = -0.000090537, b2 = 0.983729, b1 = 0.4329510, b0 = 0.238081;
    vec3 v = min(rrtFromSrgb * color, vec3(1e8));  // squares stay finite
    vec3 shown = (v * (v + vec3(a1)) + vec3(a0)) / (v * (b2 * v + vec3(b1)) + vec3(b0));
    return clamp(srgbFromOdt * shown, vec3(0.0), vec3(1.0));
}

#ifdef __cplusplus
}  // namespace vct::shared
#endif
#endif
