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

// The frame as it is shown, at a position from 0 to 1.
vec3 shownAt(vec2 position) {
    vec3 radiance = scale.x * textureLod(radianceTarget, position, 0.0).rgb;
    radiance = clamp(mix(radiance, vec3(0.0), isnan(radiance)), 0.0, 1e30);
    return srgbEncode(neutralToneMapped(radiance));
}

float luma(vec3 color) {
    return dot(color, vec3(0.299, 0.587, 0.114));
}

// Smooths edges by FXAA (Lottes 2009, "FXAA", NVIDIA; the short variant for consoles): the luma of the four
// corners of a pixel gives the direction of an edge, along which the frame is then averaged. `pixel`: size of
// a pixel of the frame.
vec3 smoothed(vec2 position, vec2 pixel) {
    // With less contrast, relative to the brightest corner or absolute, there is no edge.
    const float leastShare = 0.125, least = 0.04;
    const float longest = 8.0;        // pixels along an edge
    const float steepness = 0.03125;  // limits the length along edges that are weak or nearly diagonal
    vec3 middle = shownAt(position);
    float here = luma(middle);
    vec4 corners = vec4(
        luma(shownAt(position + vec2(-0.5, -0.5) * pixel)), luma(shownAt(position + vec2(0.5, -0.5) * pixel)),
        luma(shownAt(position + vec2(-0.5, 0.5) * pixel)), luma(shownAt(position + vec2(0.5, 0.5) * pixel)));
    float darkest = min(here, min(min(corners.x, corners.y), min(corners.z, corners.w)));
    float brightest = max(here, max(max(corners.x, corners.y), max(corners.z, corners.w)));
    if (brightest - darkest < max(least, leastShare * brightest)) return middle;

    vec2 along =
        vec2(corners.z + corners.w - corners.x - corners.y, corners.x + corners.z - corners.y - corners.w);
    along /= min(abs(along.x), abs(along.y)) + max(dot(corners, vec4(steepness)), 1.0 / 128.0);
    along = clamp(along, -longest, longest) * pixel;
    vec3 inner = 0.5 * (shownAt(position - along / 6.0) + shownAt(position + along / 6.0));
    vec3 outer = 0.5 * inner + 0.25 * (shownAt(position - 0.5 * along) + shownAt(position + 0.5 * along));
    float result = luma(outer);
    // A mean outside of the range has met another surface at the edge's end.
    return result < darkest || result > brightest ? inner : outer;
}

void main() {
    vec2 position = (gl_FragCoord.xy - rectangle.xy) / rectangle.zw;
    outColor = vec4(smoothed(position, 1.0 / vec2(textureSize(radianceTarget, 0))), 1.0);
}
