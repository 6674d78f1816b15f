// The light that a surface reflects, by rays through the directional voxels.
#include "shared/frame.glsl"
#include "shared/sky.glsl"
#include "shared/shadow.glsl"
#include "directional/ray.glsl"
#include "directional/irradiance.glsl"
#ifdef VCT_PUNCTUAL_LIGHTS
#include "shared/punctual_lights.glsl"
#else
vec3 punctualIrradiance(vec3 position, vec3 normal, float slackShare) {
    return vec3(0.0);
}
#endif

// An emitter's own voxels do not hide it.
const float ownVoxels = 2.0;

// The compact emitters around a ray, merged into one at their mean distance. Their light is not in the
// voxels.
struct EmitterHit {
    vec3 radiance;  // relative to E/pi, premultiplied by the coverage
    float coverage;
    float distance;  // in voxels
};
#ifdef VCT_EMITTERS
#include "shared/emitters.glsl"
// The share of the interval x +- wide that lies in the interval 0 +- halfSide.
float overlap(float x, float halfSide, float wide) {
    return clamp((min(x + wide, halfSide) - max(x - wide, -halfSide)) / (2.0 * wide), 0.0, 1.0);
}
// `start`: volume space. `grid`: voxels along the side of the volume.
EmitterHit emittersAlongRay(vec3 start, float grid, vec3 direction, float tangent) {
    EmitterHit met = EmitterHit(vec3(0.0), 0.0, 0.0);
    for (int i = 0; i < emitters.count.x; ++i) {
        EmitterPartUniforms part = emitters.part[i];
        float seen = projectedArea(part, direction);
        vec3 offset = part.position.xyz - start;
        float along = dot(offset, direction);
        // An emitter closer than a voxel is probably the surface itself.
        if (seen <= 0.0 || along * grid < 1.0) continue;
        float cone = max(along * tangent, 0.25 / grid);
        float share;
        if (part.side.xyz == vec3(0.0)) {
            // Overlap of two discs: one with the part's area, and the cone's.
            float disc = sqrt(seen / 3.1415927);
            share = min(disc * disc / (cone * cone), 1.0) *
                    (1.0 - smoothstep(abs(cone - disc), cone + disc, length(offset - along * direction)));
        } else {
            // Overlap of the part's rectangle with a square in its plane that has the area of the cone there.
            vec3 normal = normalize(part.facing.xyz);
            float cosine = max(-dot(direction, normal), 1e-3), away = -dot(offset, normal) / cosine;
            vec3 place = direction * away - offset;
            float wide = 0.8862269 * max(away * tangent, 0.25 / grid) * inversesqrt(cosine);
            float halfSide = length(part.side.xyz), halfOther = 0.25 * length(part.facing.xyz) / halfSide;
            vec3 side = part.side.xyz / halfSide;
            share = overlap(dot(place, side), halfSide, wide) *
                    overlap(dot(place, cross(normal, side)), halfOther, wide);
        }
        met.radiance += share * part.radiance.rgb;
        met.coverage += share;
        met.distance += share * (along - part.radiance.w) * grid;
    }
    met.distance /= max(met.coverage, 1e-6);
    float most = 1.0 / max(met.coverage, 1.0);
    return EmitterHit(met.radiance * most, met.coverage * most, met.distance);
}
#else
EmitterHit emittersAlongRay(vec3 start, float grid, vec3 direction, float tangent) {
    return EmitterHit(vec3(0.0), 0.0, 0.0);
}
#endif

// The start of rays from a pixel's surface.
struct RayStart {
    vec3 position;  // in voxels of the cascade
    int cascade;
};
RayStart rayStartAt(vec3 position, vec3 normal) {
    int cascade = lookUpCascade(position).cascade;
    return RayStart(voxelsFromVolume(position, cascade) + normal * startHeight, cascade);
}

// Smith's masking term for GGX in a direction, divided by twice its cosine (Walter et al. 2007, eq. 34).
float halfMasking(float cosine, float alpha2) {
    return 1.0 / (cosine + sqrt(alpha2 + (1.0 - alpha2) * cosine * cosine));
}

// The sum over the compact emitters of radiance, masking, solid angle, and the density of the directions of
// reflectedLight(): a few rays would find copies of a small emitter. A part is a small disc for a lobe that
// is wider by its solid angle. The strongest part tells if the surface sees them.
vec3 emittersInLobe(RayStart start, vec3 normal, vec3 toEye, float alpha) {
    vec3 light = vec3(0.0);
#ifdef VCT_EMITTERS
    float grid = voxelsAlongVolume(start.cascade), most = 0.0, distanceToMost = 0.0;
    vec3 origin = volumeFromVoxels(start.position, start.cascade), towardsMost = normal;
    for (int i = 0; i < emitters.count.x; ++i) {
        EmitterPartUniforms part = emitters.part[i];
        vec3 offset = part.position.xyz - origin;
        float away = length(offset);
        vec3 towards = offset / away;
        float cosLight = dot(normal, towards), seen = projectedArea(part, towards);
        // An emitter closer than a voxel is probably the surface itself.
        if (seen <= 0.0 || cosLight <= 0.0 || away * grid < 1.0) continue;
        float solidAngle = seen / (away * away + 0.5 / 3.1415927 * seen);
        float cosFacet = dot(normal, normalize(towards + toEye));
        float alpha2 = min(alpha * alpha + 0.25 / 3.1415927 * solidAngle, 1.0);
        float d = cosFacet * cosFacet * (alpha2 - 1.0) + 1.0;
        float density =
            alpha2 / (2.0 * 3.1415927 * d * d) * halfMasking(max(dot(normal, toEye), 1e-3), alpha2);
        vec3 added = density * solidAngle * cosLight * halfMasking(cosLight, alpha2) * part.radiance.rgb;
        light += added;
        float brightness = max(added.r, max(added.g, added.b));
        if (brightness <= most) continue;
        most = brightness;
        towardsMost = towards;
        distanceToMost = (away - part.radiance.w) * grid;
    }
    if (most == 0.0) return vec3(0.0);
    RayHit hit = traceRay(start.position, start.cascade, towardsMost, 2.0 * grid, 0.5, allGeometry);
    if (hit.distance <= distanceToMost - ownVoxels) return vec3(0.0);
#endif
    return light;
}

// The radiance of a surface where a ray meets it, relative to E/pi. Its plane, albedo and emission are the
// face's; its light is that of a pixel there. `position`: volume space.
vec3 radianceAtHit(RayHit hit, vec3 position) {
    uint at = faceAt(hit.id);
    vec3 normal = facePlane(hit.id).normal, albedo = unpackRgb9e5(faceData[at + VCT_FACE_REFLECTANCE]);
    float slackShare = slackShareOf(faceExtent(hit.id).isCurved);
    vec3 light = sampleIrradiance(position, normal) + punctualIrradiance(position, normal, slackShare);
    float cosTheta = dot(normal, frame.directionToLight.xyz);
    if (cosTheta > 0.0)
        light += cosTheta * shadowMapLightOn(position, normal, slackShare) * frame.lightColor.rgb;
    vec3 radiance = albedo * light;
#ifdef VCT_EMISSION
    radiance += unpackRgb9e5(faceData[at + VCT_FACE_EMITTED]);
#endif
    return radiance;
}

// The light that arrives along a ray from a surface, relative to E/pi. `start`: in voxels of the cascade
// `own`. `tangent`: of half the opening angle of what the ray stands for. `isSharp`: light is looked up where
// the ray ends, in place of the face's mean.
vec3 lightAlongRay(vec3 start, int own, vec3 direction, float tangent, float dice, bool isSharp) {
    float grid = voxelsAlongVolume(own);
    vec3 origin = volumeFromVoxels(start, own);
    RayHit hit = traceRay(start, own, direction, 2.0 * grid, dice, allGeometry);
    vec3 light;
    if (hit.id == noFace)
        light = sampleSky(direction, 3.1415927 * tangent * tangent);
    else
        light =
            isSharp ? radianceAtHit(hit, origin + direction * (hit.distance / grid)) : faceRadiance(hit.id);
    if (!isSharp) return light;
    EmitterHit emitter = emittersAlongRay(origin, grid, direction, tangent);
    if (emitter.coverage > 0.0 && hit.distance > emitter.distance - ownVoxels)
        light = mix(light, emitter.radiance / emitter.coverage, emitter.coverage);
    return min(light, 6e4);
}

// Rays of a sample of a rough surface. The directions of 4 x 4 neighbouring samples are parts of one set.
const int raysOfSample = 4;

// Three bits in reverse.
int reversedBits(int x) {
    return (x & 1) << 2 | (x & 2) | x >> 2;
}

// A point of the set of 64 in the unit square, which has one in each of 8 x 8 cells, 64 rows and 64 columns.
// A sample has one ray in each of 4 rows and 4 columns of wider cells, 4 x 4 in the square. The four samples
// of each row and column of 4 x 4 samples have one ray in each of these cells, because bodies that bend along
// one axis share their rays along the other alone. `sampleOfSet`: of sampleOf().
vec2 pointOfSet(int sampleOfSet, int ray) {
    int swapped = ((ray & 1) << 1) | (ray >> 1);
    int within = (sampleOfSet >> 2) ^ ray;
    int row = 2 * ray + (within & 1), column = 2 * (swapped ^ (sampleOfSet & 3)) + (within >> 1);
    return (vec2(row, column) + (vec2(reversedBits(column), reversedBits(row)) + 0.5) * 0.125) * 0.125;
}

// The light from around the mirror direction at a surface at `position` (volume space), relative to E/pi;
// rgb: weighted, a: the sum of the weights, up to 0.5. Rays go to the mirror directions of microfacets with
// the density of the normals that the eye sees (Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with
// Spherical Caps"), so what is left of the BRDF is the masking of the ray. A ray stands for the solid angle
// 1 / (directions * density), which is wide where the density is low (Krivanek and Colbert 2008).
// `directions`: those that are averaged. `sampleOfSet`: the part of the set. A smooth surface takes one ray,
// and looks up the light where it ends.
vec4 reflectedLight(vec3 position, vec3 normal, float roughness, float directions, int sampleOfSet) {
    bool isSharp = roughness < 0.3, isMirror = roughness < halfFrom;
    float alpha = roughness * roughness, alpha2 = max(alpha * alpha, 1e-6);
    int rays = isMirror ? 1 : raysOfSample;
    mat3 axes = frameAround(normal);
    RayStart start = rayStartAt(position, normal);
    vec3 view = normalize(position - frame.eye.xyz), toEye = -view * axes;
    toEye.y = max(toEye.y, 1e-3);
    vec3 stretch = vec3(alpha, 1.0, alpha), stretched = normalize(toEye * stretch);
    float perDensity = 2.0 / (directions * alpha2 * halfMasking(toEye.y, alpha2));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < rays; ++i) {
        vec2 u = pointOfSet(sampleOfSet, i);
        float height = 1.0 - u.x * (1.0 + stretched.y), azimuth = 6.2831853 * u.y;
        float radius = sqrt(max(1.0 - height * height, 0.0));
        vec3 cap = vec3(radius * cos(azimuth), height, radius * sin(azimuth));
        vec3 facet = isMirror ? vec3(0.0, 1.0, 0.0) : normalize((cap + stretched) * stretch);
        vec3 direction = axes * (2.0 * dot(toEye, facet) * facet - toEye);
        float cosine = dot(direction, normal);
        if (cosine <= 0.0) continue;
        float weight = cosine * halfMasking(cosine, alpha2) / float(rays);
        float tangent = (1.0 + (alpha2 - 1.0) * facet.y * facet.y) * sqrt(perDensity);
        vec3 light = lightAlongRay(start.position, start.cascade, direction, min(tangent, 1.0), 0.5, isSharp);
        sum += weight * vec4(light, 1.0);
    }
    if (!isSharp) sum.rgb += emittersInLobe(start, normal, -view, alpha);
    return min(sum, 6e4);
}

// The part of the set for each pixel of 4 x 4: 2 bits of the column, and 2 of the cell.
int sampleOf(ivec2 pixel) {
    ivec2 place = pixel & 3;
    return (place.x ^ place.y) | place.y << 2;
}
