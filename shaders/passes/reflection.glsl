// The light that a surface reflects: one cone along the mirror direction, through directional voxels.
// VCT_REFLECTION_COUNTER counts its samples.
#include "shared/frame.glsl"
#include "shared/sky.glsl"
#include "directional/cones.glsl"

// The compact emitters that a cone meets, merged into one at their mean distance. Their light is not in the
// voxels.
struct EmitterHit {
    vec3 radiance;  // relative to E/pi, premultiplied by the coverage
    float coverage;
    float distance;  // to the first of the emitters' own voxels, in voxels
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
            // Overlap of a square as wide as the cone with the part's rectangle, in the plane of the
            // rectangle.
            vec3 normal = normalize(part.facing.xyz);
            vec3 place = direction * (dot(offset, normal) / min(dot(direction, normal), -1e-3)) - offset;
            float halfSide = length(part.side.xyz), halfOther = 0.25 * length(part.facing.xyz) / halfSide;
            vec3 side = part.side.xyz / halfSide;
            share = overlap(dot(place, side), halfSide, cone) *
                    overlap(dot(place, cross(normal, side)), halfOther, cone);
        }
        met.radiance += share * part.radiance.rgb;
        met.coverage += share;
        met.distance += share * (along - endOfCones(part)) * grid;
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

// A ray through the faces: the loop-invariant part of sampleFaces() in directional/cones.glsl, which says how
// faces are weighted.
struct FaceRay {
    vec3 side;                      // y of the block of faces opposite to the ray, per axis
    mediump vec3 share, shareNear;  // weight of each axis, and the same without the faces of the own surface
};

FaceRay faceRayFrom(vec3 normal, vec3 direction) {
    mediump vec3 share = abs(direction);
    bvec3 own = lessThan(direction * normal, ownFaces(normal, false));
    return FaceRay(mix(vec3(0.0), vec3(blockSize.y), greaterThan(direction, vec3(0.0))), share,
                   mix(share, vec3(0.0), own));
}

// Premultiplied radiance and coverage, up to 1, at a position (volume space) and level. `texel`: width of the
// level's texels; `inside`: distance of the position from the volume's border. All in voxels of the cascade
// `own`.
mediump vec4 facesAt(FaceRay ray, mediump vec3 share, vec3 position, int own, float level, float texel,
                     float inside) {
    int cascade = cascadeOfSample(position, own, level);
    if (cascades > 1) level = max(level + float(own - cascade), 0.0);
    vec3 p = faceCoordinates(position, cascade, cascades == 1 ? texel : exp2(level));
    mediump vec4 x = textureLod(faces, p + vec3(0.0, ray.side.x, 0.0), level);
    mediump vec4 y = textureLod(faces, p + vec3(blockSize.x, ray.side.y, 0.0), level);
    mediump vec4 z = textureLod(faces, p + vec3(2.0 * blockSize.x, ray.side.z, 0.0), level);
    mediump vec3 square = share * share;
    mediump vec4 shining = square.x * x + square.y * y + square.z * z;
    mediump float coverage =
        min(dot(share, vec3(x.a, y.a, z.a)), 1.0) * clamp(inside / texel + 0.5, 0.0, 1.0);
    return vec4(shining.rgb * (coverage / max(shining.a, 1e-4)), coverage);
}

// Traces one cone of a reflection. Lengths in voxels of the cascade `own`.
//
// Samples are one footprint apart, and those whose footprint is between two levels blend both, each weighted
// by its texel size: a wall's coverage then adds up to 1 over the samples, wherever they lie. Otherwise the
// distances of the samples would show as rings.
//
// Each turn of the loop looks up one level. Of two levels to blend, the wider comes first: where it is empty,
// so is the finer. Empty space is passed in larger steps: a texel four times as wide, ahead of the cone,
// tells whether there are faces.
mediump vec3 traceReflection(vec3 start, int own, vec3 normal, vec3 direction, float tangent) {
    const mediump float threshold = 0.1;  // a cone with less transmittance ends
    float grid = voxelsAlongVolume(own), rise = dot(direction, normal);
    FaceRay ray = faceRayFrom(normal, direction);
    EmitterHit hit = emittersAlongRay(volumeFromVoxels(start, own), grid, direction, tangent);
    mediump vec3 radiance = vec3(0.0);
    mediump vec4 wider;
    mediump float transmittance = 1.0;
    float distance = VCT_GATHER_FIRST_SAMPLE, level = 0.0, texel = 1.0, sampledTo = 0.0;
    bool hasWider = false;
    while (distance < 2.0 * grid) {
        COUNT(VCT_REFLECTION_COUNTER);
        // The footprint is limited to a quarter of the volume's side.
        float height = VCT_GATHER_START + distance * rise;
        float footprint = clamp(min(2.0 * distance * tangent, height), 1.0, 0.25 * grid);
        if (footprint >= 2.0 * texel) {
            level += 1.0;
            texel *= 2.0;
        }
        if (cascades > 1) {
            // A coarser cascade has no smaller texels.
            vec3 at = volumeFromVoxels(start + direction * distance, own);
            level = max(level, float(cascadeOfSample(at, own, level) - own));
            texel = exp2(level);
            footprint = max(footprint, texel);
        }
        // The emitter's light is added before the cone reaches the emitter's own voxels.
        if (hit.coverage > 0.0 && distance > hit.distance - footprint) {
            radiance += hit.radiance * (transmittance / faceRange.radiance);
            transmittance *= 1.0 - hit.coverage;
            hit.coverage = 0.0;
        }
        bool looksAhead = distance >= sampledTo;
        mediump float blend = clamp(footprint / texel, 1.0, 2.0) - 1.0;
        bool isWider = blend > 0.0 && !hasWider;
        float coarser = looksAhead ? 2.0 : isWider ? 1.0 : 0.0;
        float width = (looksAhead ? 4.0 : isWider ? 2.0 : 1.0) * texel;
        vec3 position =
            volumeFromVoxels(start + direction * (looksAhead ? distance + 0.5 * width : distance), own);
        vec3 fromCentre = abs(position - 0.5);
        float inside = grid * (0.5 - max(fromCentre.x, max(fromCentre.y, fromCentre.z)));
        // The cone ends when the widest of the texels is outside of the volume.
        if (inside + (looksAhead ? width : texel) <= 0.0) break;
        bool isNear = !looksAhead && height < VCT_GATHER_OWN_SURFACE * width;
        mediump vec4 met = facesAt(ray, isNear ? ray.shareNear : ray.share, position, own, level + coarser,
                                   width, looksAhead ? width : inside);
        if (looksAhead) {
            // The filter reaches one texel beyond the empty space.
            if (met.a > 0.0)
                sampledTo = distance + width;
            else
                distance += width - texel;
            continue;
        }
        // Near its own surface the wider look-up leaves out faces that the finer one may meet.
        if (isWider && (met.a > 0.0 || isNear)) {
            wider = met;
            hasWider = true;
            continue;
        }
        if (hasWider) met = mix(met, 0.5 * wider, blend);
        hasWider = false;
        mediump float taken = min(VCT_GATHER_STEP * (1.0 + blend) * met.a, transmittance);
        radiance += met.rgb * (taken / max(met.a, 1e-4));
        transmittance -= taken;
        if (transmittance < threshold) break;
        distance += VCT_GATHER_STEP * footprint;
    }
    return min(radiance * faceRange.radiance, 6e4) +
           transmittance * sampleSky(direction, 3.1415927 * tangent * tangent);
}

// The light that arrives at a surface at `position` (volume space) from around its mirror direction, relative
// to E/pi. The median angle between the normals of the surface and its microfacets has the tangent alpha
// (Walter et al. 2007, eq. 35 at one half). The cone is narrower, because the filter of the faces reaches
// half a texel beyond its footprint on each side (measured, docs/history/gloss.md).
const float coneWidth = 0.6;
mediump vec3 reflectedLight(vec3 position, vec3 normal, mediump float roughness) {
    int own = lookUpCascade(position).cascade;
    vec3 start = voxelsFromVolume(position, own) + normal * VCT_GATHER_START;
    return traceReflection(start, own, normal, reflect(normalize(position - frame.eye.xyz), normal),
                           coneWidth * roughness * roughness);
}
