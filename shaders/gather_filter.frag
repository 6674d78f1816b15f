// The mean over the 4 x 4 turns of the cones, of those gather pixels that share the surface.
#include "shared/trips.glsl"
#include "shared/gather_surface.glsl"
#include "shared/precision.glsl"
#include "shared/surface.glsl"

layout(binding = VCT_TEX_GATHER) uniform mediump sampler2D gatherTarget;
layout(binding = VCT_TEX_GATHER_SURFACE) uniform highp sampler2D gatherSurface;

layout(location = 0) out mediump vec4 outGather;

void main() {
    TRIP(VCT_TRIPS_GATHER_FILTER);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(gatherTarget, 0) - 1;
    outGather = vec4(0.0);
    ivec2 fullPixel = gatheredPixel(pixel, textureSize(depthTarget, 0));
    float depth = surfaceDepth(fullPixel);
    if (depth == 1.0) return;
    vec3 position = surfacePosition(fullPixel, depth);
    vec3 normal = texelFetch(gatherSurface, pixel, 0).xyz;
    float voxel = 1.0 / float(frame.grid.x);
    mediump vec4 sum = vec4(0.0);
    mediump float count = 0.0;
    for (int y = -2; y < 2; ++y)
        for (int x = -2; x < 2; ++x) {
            TRIP(VCT_TRIPS_GATHER_FILTER_NEIGHBOUR);
            ivec2 other = clamp(pixel + ivec2(x, y), ivec2(0), last);
            if (!sharesSurface(position, normal, texelFetch(gatherSurface, other, 0), voxel)) continue;
            sum = HALF(sum + texelFetch(gatherTarget, other, 0));
            count += 1.0;
        }
    outGather = HALF(sum / max(count, 1.0));
}
