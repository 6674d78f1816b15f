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

// Along the screen, from or to the next pixel's surface: whichever side's lies nearer to the plane of the normal, as the
// other may be behind a crease or a silhouette.
vec3 tangent(ivec2 pixel, ivec2 onePixel, ivec2 last, vec3 position, vec3 normal) {
    ivec2 before = max(pixel - onePixel, ivec2(0)), after = min(pixel + onePixel, last);
    vec3 back = position - surfacePosition(before, surfaceDepth(before));
    vec3 on = surfacePosition(after, surfaceDepth(after)) - position;
    if (before == pixel) return on;
    return after == pixel || abs(dot(back, normal)) < abs(dot(on, normal)) ? back : on;
}

// Of the triangle, which the interpolated normal may lean away from: along that, where something round stands on a floor,
// cones would start below the floor. The interpolated one at what is thinner than pixels are.
vec3 facetNormal(ivec2 pixel, ivec2 size, vec3 position, vec3 normal) {
    vec3 right = tangent(pixel, ivec2(1, 0), size - 1, position, normal);
    vec3 up = tangent(pixel, ivec2(0, 1), size - 1, position, normal);
    vec3 across = cross(right, up);
    float agreement = dot(across, normal);
    float reach = 2.0 / float(frame.grid.x);  // farther than that, it is another surface
    bool known = max(dot(right, right), dot(up, up)) < reach * reach && abs(agreement) > 0.3 * length(across);
    return known ? normalize(across) * sign(agreement) : normal;
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
    vec3 facet = facetNormal(pixel, size, position, normal);
    vec3 start = position * float(frame.grid.x) + facet * VCT_GATHER_START;
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
        if (dot(volumeFromCone * cone, facet) < -0.15) continue;  // into the solid: dark
        ConeResult result = traceCone(start, normal, volumeFromCone * cone, reach);
        outGather.rgb += result.radiance + result.transmittance * frame.skyRadiance.rgb;
        outGather.a += result.transmittance;
    }
    outGather = HALF(outGather / float(VCT_GATHER_CONES));
}
