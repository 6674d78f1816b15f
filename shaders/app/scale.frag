// Scales the smoothed frame to the rectangle of the window that shows it.
layout(binding = 0) uniform mediump sampler2D frame;  // sRGB-encoded
layout(location = 0) uniform vec4 rectangle;          // xy: origin in the window, zw: 1 / size, in pixels
layout(location = 0) out mediump vec4 outColor;

void main() {
    outColor = vec4(textureLod(frame, (gl_FragCoord.xy - rectangle.xy) * rectangle.zw, 0.0).rgb, 1.0);
}
