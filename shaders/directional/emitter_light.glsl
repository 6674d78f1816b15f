// The light of the compact emitters at a point: a closed form gives the share of the hemisphere that a part
// of an emitter fills, and rays to points of the part tell how much of it is visible (next event estimation).
#include "directional/ray.glsl"
#include "shared/emitters.glsl"

// The smallest positive half float.
const float minStoredLight = 6e-8;

// A part as a point sees it.
struct SeenPart {
    vec3 towards;    // unit length
    float distance;  // to its middle, in sides of the volume
    vec3 light;      // irradiance if nothing is in between, relative to E
};

// `position` in volume space.
SeenPart seenPart(EmitterPartUniforms part, vec3 position, vec3 normal) {
    vec3 offset = part.position.xyz - position;
    float distance = max(length(offset), 1e-6);
    vec3 towards = offset / distance;
    float area = projectedArea(part, towards);
    // Form factor of a small disc. Close to it, the area in the denominator keeps the factor below 1, as for
    // a disc that faces the surface.
    float share = max(dot(towards, normal), 0.0) * area / (3.1415927 * distance * distance + area);
    return SeenPart(towards, distance, part.radiance.rgb * share);
}

bool isStorable(vec3 light) {
    return max(light.r, max(light.g, light.b)) >= minStoredLight;
}

// A point in front of a part, in volume space; `u` in 0..1 selects it. It is so far in front that the part's
// own voxels, and those of a surface that it lies on, do not block the ray to it.
vec3 pointOfPart(EmitterPartUniforms part, SeenPart seen, vec2 u, float voxel) {
    const float inFront = 0.5;  // voxels
    vec2 aside = 2.0 * u - 1.0;
    if (part.side.xyz == vec3(0.0)) {
        mat3 axes = frameAround(seen.towards);
        float radius = sqrt(u.x) * part.position.w, angle = 6.2831853 * u.y;
        vec3 disc = axes[0] * (radius * cos(angle)) + axes[2] * (radius * sin(angle));
        return part.position.xyz + disc - seen.towards * (part.radiance.w + inFront * voxel);
    }
    vec3 normal = normalize(part.facing.xyz);
    vec3 other =
        cross(normal, part.side.xyz) * (0.25 * length(part.facing.xyz) / dot(part.side.xyz, part.side.xyz));
    return part.position.xyz + aside.x * part.side.xyz + aside.y * other +
           normal * (part.radiance.w + inFront * voxel);
}

// The share of a part that a point sees through some of the geometry. `start`: in voxels of a cascade.
float visibleShare(EmitterPartUniforms part, SeenPart seen, vec3 start, int cascade, uint geometry) {
    // If the first rays agree, the part is visible as a whole or not at all.
    const int first = 4, all = 16;
    float voxel = 1.0 / voxelsAlongVolume(cascade), visible = 0.0;
    int rays = first;
    for (int i = 0; i < rays; ++i) {
        COUNT(VCT_EMITTER_RAY);
        // A sequence that covers the square evenly (Roberts 2018, "The unreasonable effectiveness of
        // quasirandom sequences").
        vec2 u = fract(0.5 + float(i) * vec2(0.7548777, 0.5698403));
        vec3 end = voxelsFromVolume(pointOfPart(part, seen, u, voxel), cascade), way = end - start;
        float distance = length(way);
        if (traceRay(start, cascade, way / distance, distance, diceOf(i, ivec3(start)), geometry).id ==
            noFace)
            visible += 1.0;
        if (i == first - 1 && visible > 0.0 && visible < float(first)) rays = all;
    }
    return visible / float(rays);
}
