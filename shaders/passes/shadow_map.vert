// Depth from the light (thesis 4.2).
#include "directional/blocks.glsl"
#include "shared/draw.glsl"

layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;
#ifdef VCT_ALPHA_MASK
layout(location = VCT_ATTRIBUTE_UV) in vec2 uv;
out vec2 fragmentUv;
#endif

void main() {
    vec4 shadow = frame.shadowFromVolume * (draw.volumeFromObject * vec4(position, 1.0));
    gl_Position = vec4(shadow.xyz * 2.0 - 1.0, 1.0);
#ifdef VCT_ALPHA_MASK
    fragmentUv = uv;
#endif
}
