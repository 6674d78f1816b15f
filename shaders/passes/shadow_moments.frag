// The finest level of the shadow map's moments (shared/moments.glsl), half as fine as the map.
#include "shared/counters.glsl"
#include "shared/moments.glsl"

layout(binding = VCT_TEX_SHADOW_DEPTH) uniform highp sampler2D finest;

layout(location = 0) out vec2 outMoments;

void main() {
    COUNT(VCT_COUNTER_SHADOW_MOMENTS);
    vec2 texel = 1.0 / vec2(textureSize(finest, 0));
    vec2 middle = 2.0 * floor(gl_FragCoord.xy) + 1.0;
    vec4 at = vec4(middle - 1.0, middle + 1.0) * texel.xyxy;
    vec2 moments = momentsOf(textureGather(finest, at.xy), textureGather(finest, at.zy), textureGather(finest, at.xw),
                             textureGather(finest, at.zw));
    outMoments = vec2(moments.x - momentMiddle, moments.y * momentUnit) * momentUnit;
}
