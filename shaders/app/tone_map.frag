// Brings each rendered pixel to the colour that the screen shows: exposure, tone mapping and sRGB.
// smooth.frag reads the luma in alpha.
#include "shared/tone_map.h"

layout(binding = 0) uniform sampler2D radianceTarget;  // rgb relative to E/pi
layout(location = 0) uniform vec4 scale;               // x: E/pi times exposure
layout(location = 0) out vec4 outColor;

// IEC 61966-2-1, the same as srgbEncode() in jni/image.
vec3 srgbEncode(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

void main() {
    vec3 radiance = scale.x * texelFetch(radianceTarget, ivec2(gl_FragCoord.xy), 0).rgb;
    radiance = clamp(mix(radiance, vec3(0.0), isnan(radiance)), 0.0, 1e30);
    vec3 shown = srgbEncode(neutralToneMapped(radiance));
    outColor = vec4(shown, dot(shown, vec3(0.299, 0.587, 0.114)));
}
