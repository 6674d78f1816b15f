// The finest level of the shadow map's moments (shared/moments.glsl), half as fine as the map.
#include "shared/counters.glsl"
#include "shared/moments.glsl"

layout(binding = VCT_TEX_SHADOW_DEPTH) uniform highp sampler2D finest;

layout(location = 0) out vec2 outMoments;

void main() {
    COUNT(VCT_COUNTER_SHADOW_MOMENTS);
    vec2 at = (2.0 * gl_FragCoord.xy - 1.0) / vec2(textureSize(finest, 0));
    vec2 moments =
        momentsOf(textureGather(finest, at), textureGatherOffset(finest, at, ivec2(2, 0)),
                  textureGatherOffset(finest, at, ivec2(0, 2)), textureGatherOffset(finest, at, ivec2(2, 2)));
    outMoments = vec2(moments.x - momentMiddle, moments.y * momentUnit + leastVariance / momentUnit) * momentUnit;
}
