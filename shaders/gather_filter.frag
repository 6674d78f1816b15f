// The mean over the 4 x 4 turns of the cones, of those gather pixels that share the surface.
#include "shared/trips.glsl"
#include "shared/gather_surface.glsl"
#include "shared/precision.glsl"
#include "shared/surface.glsl"

layout(binding = VCT_TEX_GATHER) uniform mediump sampler2D gatherTarget;
layout(binding = VCT_TEX_GATHER_SURFACE) uniform highp sampler2D gatherSurface;

layout(location = 0) out mediump vec4 outGather;
layout(location = 1) out vec4 outSurface;

void main() {
    TRIP(VCT_TRIPS_GATHER_FILTER);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 size = textureSize(depthTarget, 0);
    ivec2 tile = tileSize(size);
    ivec2 last = (size - 1) / VCT_GATHER_SCALE;
    outGather = vec4(0.0);
    outSurface = vec4(0.0);
    ivec2 fullPixel = gatheredPixel(pixel, size, VCT_TRIPS_GATHER_FILTER_SEARCH);
    float depth = surfaceDepth(fullPixel);
    if (depth == 1.0) return;
    vec3 position = surfacePosition(fullPixel, depth);
    outSurface = texelFetch(gatherSurface, storedPixel(pixel, tile), 0);
    vec3 normal = outSurface.xyz;
    float voxel = 1.0 / float(frame.grid.x);
    mediump vec4 sum = vec4(0.0);
    mediump float count = 0.0;
    for (int y = -2; y < 2; ++y)
        for (int x = -2; x < 2; ++x) {
            TRIP(VCT_TRIPS_GATHER_FILTER_NEIGHBOUR);
            ivec2 other = storedPixel(clamp(pixel + ivec2(x, y), ivec2(0), last), tile);
            if (!sharesSurface(position, normal, texelFetch(gatherSurface, other, 0), voxel)) continue;
            sum = HALF(sum + texelFetch(gatherTarget, other, 0));
            count += 1.0;
        }
    outGather = HALF(sum / max(count, 1.0));
}
