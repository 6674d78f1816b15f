// What the hemisphere over each gather pixel sends: VCT_GATHER_CONES cones, a Fibonacci set with weights that contain
// the cosine, turned from pixel to pixel over a pattern of 4 x 4 that the filter after it averages.
#define VCT_CONE_TRIPS VCT_TRIPS_GATHER_STEP
#include "shared/trips.glsl"
#include "shared/face_cones.glsl"
#include "shared/gather_surface.glsl"
#include "shared/surface.glsl"

layout(location = 0) out mediump vec4 outGather;  // rgb: radiance relative to E/pi, before albedo; a: openness
layout(location = 1) out vec4 outSurface;

// Ordered as Bayer's matrix, so that any 2 x 2 pixels are turned by about quarters.
int rotationOf(ivec2 p) {
    int even = (p.x ^ p.y) & 1, odd = (p.x ^ p.y) >> 1;
    return 8 * even + 4 * (p.y & 1) + 2 * odd + (p.y >> 1);
}

void main() {
    TRIP(VCT_TRIPS_GATHER);
    ivec2 size = textureSize(depthTarget, 0);
    ivec2 stored = ivec2(gl_FragCoord.xy);
    ivec2 tile = tileSize(size);
    int tileOfPixel = stored.x / tile.x;
    ivec2 inPattern = ivec2(tileOfPixel & 3, tileOfPixel >> 2);
    ivec2 inTile = ivec2(stored.x - tileOfPixel * tile.x, stored.y);
    ivec2 pixel = gatheredPixel(inTile * 4 + inPattern, size, VCT_TRIPS_GATHER_SEARCH);
    float depth = surfaceDepth(pixel);
    outGather = vec4(0.0);
    outSurface = vec4(0.0);
    if (depth == 1.0) return;

    vec3 position = surfacePosition(pixel, depth);
    vec3 normal = surfaceNormal(pixel);
    outSurface = vec4(normal, dot(normal, position));
    vec3 start = position * float(frame.grid.x) + normal * VCT_GATHER_START;
    mat3 volumeFromCone = frameAround(normal);
    int rotation = rotationOf(inPattern);
#ifdef VCT_GATHER_OCCLUSION
    float reach = frame.cone.y * float(frame.grid.x);
#else
    float reach = 2.0 * float(frame.grid.x);
#endif
    for (int i = 0; i < VCT_GATHER_CONES; ++i) {
        TRIP(VCT_TRIPS_GATHER_CONE);
        vec3 cone = gatherCone(i, rotation);
        ConeResult result = traceCone(start, normal, volumeFromCone * cone, reach);
        outGather.rgb += result.radiance + result.transmittance * frame.skyRadiance.rgb;
        outGather.a += result.transmittance;
    }
    outGather = HALF(outGather / float(VCT_GATHER_CONES));
}
