// Marks the texels of passes/gloss_half.frag that have a cone: its triangle has the depth 0.5 and is drawn
// only where the depth is larger.
#include "passes/rough_pixel.glsl"

layout(location = 0) out mediump vec4 outSample;

void main() {
    outSample = vec4(0.0);
    gl_FragDepth = roughPixel(ivec2(gl_FragCoord.xy)) >= 0 ? 1.0 : 0.0;
}
