// Shows a frame in the window: scales it to the window's size, and applies exposure, tone mapping and sRGB.
#include "shared/tone_map.h"

layout(binding = 0) uniform sampler2D radianceTarget;  // rgb relative to E/pi
layout(location = 0) uniform vec4 scale;               // x: E/pi times exposure
layout(location = 1) uniform vec4 rectangle;           // origin and size in the window, in pixels
layout(location = 0) out vec4 outColor;

// IEC 61966-2-1, the same as srgbEncode() in jni/image.
vec3 srgbEncode(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

void main() {
    vec2 position = (gl_FragCoord.xy - rectangle.xy) / rectangle.zw;
    vec3 radiance = scale.x * texture(radianceTarget, position).rgb;
    radiance = clamp(mix(radiance, vec3(0.0), isnan(radiance)), 0.0, 1e30);
    outColor = vec4(srgbEncode(neutralToneMapped(radiance)), 1.0);
}
