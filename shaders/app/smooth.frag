// Smooths edges by FXAA (Lottes 2009, "FXAA", NVIDIA; the short variant for consoles): the luma of the four
// corners of a pixel gives the direction of an edge, along which the frame is then averaged.
layout(binding = 0) uniform mediump sampler2D frame;  // sRGB-encoded, with its luma in alpha
layout(location = 0) out mediump vec4 outColor;

void main() {
    // With less contrast, relative to the brightest corner or absolute, there is no edge.
    const mediump float leastShare = 0.125, least = 0.04;
    const mediump float longest = 8.0;  // pixels along an edge
    const mediump float steepness =
        0.03125;  // limits the length along edges that are weak or nearly diagonal
    vec2 pixel = 1.0 / vec2(textureSize(frame, 0));
    vec2 position = gl_FragCoord.xy * pixel;
    mediump vec4 middle = textureLod(frame, position, 0.0);
    outColor = vec4(middle.rgb, 1.0);
    // The filter averages the four pixels around a corner.
    mediump vec4 corners = vec4(textureLod(frame, position + vec2(-0.5, -0.5) * pixel, 0.0).a,
                                textureLod(frame, position + vec2(0.5, -0.5) * pixel, 0.0).a,
                                textureLod(frame, position + vec2(-0.5, 0.5) * pixel, 0.0).a,
                                textureLod(frame, position + vec2(0.5, 0.5) * pixel, 0.0).a);
    mediump float darkest = min(middle.a, min(min(corners.x, corners.y), min(corners.z, corners.w)));
    mediump float brightest = max(middle.a, max(max(corners.x, corners.y), max(corners.z, corners.w)));
    if (brightest - darkest < max(least, leastShare * brightest)) return;

    mediump vec2 along =
        vec2(corners.z + corners.w - corners.x - corners.y, corners.x + corners.z - corners.y - corners.w);
    along /= min(abs(along.x), abs(along.y)) + max(dot(corners, vec4(steepness)), 1.0 / 128.0);
    vec2 reach = clamp(along, -longest, longest) * pixel;
    mediump vec4 inner = 0.5 * (textureLod(frame, position - reach / 6.0, 0.0) +
                                textureLod(frame, position + reach / 6.0, 0.0));
    mediump vec4 outer = 0.5 * inner + 0.25 * (textureLod(frame, position - 0.5 * reach, 0.0) +
                                               textureLod(frame, position + 0.5 * reach, 0.0));
    // A mean outside of the range has met another surface at the edge's end.
    outColor.rgb = outer.a < darkest || outer.a > brightest ? inner.rgb : outer.rgb;
}
