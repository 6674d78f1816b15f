// The light of the compact emitters at a point: a closed form gives the share of the light that a part would
// give without obstacles, and rays to points of the part tell how much of it is visible (next event
// estimation).
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

// A part's flat area as a rectangle around its position: half of its sides, the second one across the first.
struct PartRectangle {
    vec3 side, other, normal;
};
PartRectangle rectangleOf(EmitterPartUniforms part) {
    vec3 side = part.side.xyz;
    float area = length(part.facing.xyz);
    vec3 normal = part.facing.xyz / area;
    return PartRectangle(side, cross(normal, side) * (0.25 * area / dot(side, side)), normal);
}

// The part of a polygon's form factor that belongs to one edge, times 2 pi. `a`, `b`: ends of the edge, from
// the point.
float edgeFactor(vec3 a, vec3 b, vec3 normal) {
    vec3 across = cross(a, b);
    float sine = length(across);
    return atan(sine, dot(a, b)) * dot(across, normal) / max(sine, 1e-20);
}

// Form factor of a rectangle, at a point of a surface with this normal (Lambert 1760). `middle`: of the
// rectangle, from the point. What is below the surface's horizon is cut off.
float formFactor(PartRectangle rectangle, vec3 middle, vec3 normal) {
    float sum = 0.0;
    vec3 enters = vec3(0.0), leaves = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        vec2 from = vec2(i == 1 || i == 2 ? 1.0 : -1.0, i < 2 ? -1.0 : 1.0), to = vec2(-from.y, from.x);
        vec3 a = middle + from.x * rectangle.side + from.y * rectangle.other;
        vec3 b = middle + to.x * rectangle.side + to.y * rectangle.other;
        float above = dot(a, normal), aboveNext = dot(b, normal);
        if (max(above, aboveNext) <= 0.0) continue;
        vec3 cut = mix(a, b, above / (above - aboveNext));
        if (above <= 0.0) enters = a = cut;
        if (aboveNext <= 0.0) leaves = b = cut;
        sum -= edgeFactor(a, b, normal);
    }
    return max(sum - edgeFactor(leaves, enters, normal), 0.0) / 6.2831853;
}

// `position` in volume space.
SeenPart seenPart(EmitterPartUniforms part, vec3 position, vec3 normal) {
    vec3 offset = part.position.xyz - position;
    float distance = max(length(offset), 1e-6);
    vec3 towards = offset / distance;
    // A closed convex surface is as bright as a sphere with the same area.
    float round = part.facing.w;
    float share = max(dot(towards, normal), 0.0) * min(round / (3.1415927 * distance * distance), 1.0);
    if (part.side.xyz != vec3(0.0)) share += formFactor(rectangleOf(part), offset, normal);
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
    PartRectangle rectangle = rectangleOf(part);
    return part.position.xyz + aside.x * rectangle.side + aside.y * rectangle.other +
           rectangle.normal * (part.radiance.w + inFront * voxel);
}

// The share of a part that a point sees through some of the geometry. `start`: in voxels of a cascade.
float visibleShare(EmitterPartUniforms part, SeenPart seen, vec3 start, int cascade, uint geometry) {
    // If the first rays agree, the part is visible as a whole or not at all.
    const int first = 4, all = 16;
    float voxel = 1.0 / voxelsAlongVolume(cascade), visible = 0.0;
    int rays = first;
    for (int i = 0; i < rays; ++i) {
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
