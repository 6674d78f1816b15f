// The gathered light at a full-resolution pixel: bilinear between the gather pixels that share its surface.
#include "shared/blocks.glsl"
#include "shared/gather_surface.glsl"
#include "shared/precision.glsl"
#include "shared/trips.glsl"

layout(binding = VCT_TEX_GATHER) uniform mediump sampler2D gatherTarget;
layout(binding = VCT_TEX_GATHER_SURFACE) uniform highp sampler2D gatherSurface;

struct Gather {
    mediump vec3 radiance;   // relative to E/pi
    mediump float openness;  // 1 - ambient occlusion
};

// The least that a gather pixel of the same surface weighs, so that a pixel right on top of a foreign one still finds
// one of its own; and what one of another surface weighs, which counts only where there is no other, on a thing thinner
// than the gather's pixels. A quarter of it, the least that the nearest of four can have, is still a normal half.
const float leastOwn = 1.0 / 64.0;
const float foreign = 1.0 / 4096.0;

Gather gatheredAt(ivec2 pixel, vec3 position, vec3 normal) {
    ivec2 last = textureSize(gatherTarget, 0) - 1;
    vec2 gatherPixel = (vec2(pixel) - float(VCT_GATHER_SCALE / 2)) / float(VCT_GATHER_SCALE);
    ivec2 low = ivec2(floor(gatherPixel));
    mediump vec2 part = gatherPixel - vec2(low);
    float voxel = 1.0 / float(frame.grid.x);
    mediump vec4 sum = vec4(0.0);
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        TRIP(VCT_TRIPS_GATHERED_CORNER);
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 other = clamp(low + corner, ivec2(0), last);
        mediump vec2 weights = mix(1.0 - part, part, vec2(corner));
        vec4 surface = texelFetch(gatherSurface, other, 0);
        float weight = max(weights.x * weights.y, leastOwn);
        if (!sharesSurface(position, normal, surface, voxel)) weight *= surface == vec4(0.0) ? 0.0 : foreign;
        sum += HALF(weight * texelFetch(gatherTarget, other, 0));
        total += weight;
    }
    mediump vec4 mean = HALF(sum / max(total, 1e-6));
    return Gather(mean.rgb, mean.a);
}
