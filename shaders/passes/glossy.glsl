// glTF's metallic-roughness materials (glTF 2.0, appendix B: GGX with alpha = roughness^2, Schlick's Fresnel
// term). The sun and the punctual lights use the formulas of the appendix. Indirect specular light comes from
// one cone along the mirror direction and, for rough surfaces, from face irradiance.
#include "shared/frame.glsl"
#include "shared/sky.glsl"
#include "directional/cones.glsl"

// Between these roughnesses the cone is blended with face irradiance, because many cones of a gather fit a
// wide lobe better than one cone does (docs/design-decisions.md).
const float roughFrom = 0.3;
const float roughTo = 0.9;

// The material of a pixel.
struct Brdf {
    mediump vec3 diffuse;  // diffuse albedo
    mediump vec3 f0;       // Schlick's term at normal incidence
    mediump float f90;     // Schlick's term at grazing incidence; 0: the surface is Lambertian
    mediump float roughness;
    vec3 toEye;  // unit length
};

// Metals reflect specularly up to the roughness 1. The reflection of other materials fades out from .9 on, so
// that those of roughness 1, which are most, are Lambertian and need no gloss in the G-buffer.
Brdf brdfOf(mediump vec3 albedo, mediump float metallic, mediump float roughness, vec3 toEye) {
    mediump float fade = clamp((1.0 - roughness) * 10.0, 0.0, 1.0);
    return Brdf(albedo * (1.0 - metallic), mix(vec3(0.04 * fade), albedo, metallic), mix(fade, 1.0, metallic),
                roughness, toEye);
}

vec3 schlick(Brdf brdf, float cosine) {
    return brdf.f0 + (brdf.f90 - brdf.f0) * pow(1.0 - cosine, 5.0);
}

// Pi times the radiance towards the eye, without shadow, by a punctual light that gives a surface that faces
// it the irradiance 1.
vec3 evaluateBrdf(Brdf brdf, vec3 normal, vec3 toLight) {
    float cosLight = dot(normal, toLight);
    if (cosLight <= 0.0) return vec3(0.0);
    if (brdf.f90 == 0.0) return brdf.diffuse * cosLight;
    float cosEye = max(dot(normal, brdf.toEye), 1e-3);
    vec3 halfway = normalize(toLight + brdf.toEye);
    float cosHalf = max(dot(normal, halfway), 0.0);
    float alpha2 = max(pow(brdf.roughness, 4.0), 1e-6);
    float d = cosHalf * cosHalf * (alpha2 - 1.0) + 1.0;
    float visibility = 1.0 / ((cosLight + sqrt(alpha2 + (1.0 - alpha2) * cosLight * cosLight)) *
                              (cosEye + sqrt(alpha2 + (1.0 - alpha2) * cosEye * cosEye)));
    vec3 fresnel = schlick(brdf, clamp(dot(brdf.toEye, halfway), 0.0, 1.0));
    return min((brdf.diffuse * (1.0 - fresnel) + fresnel * (alpha2 / (d * d) * visibility)) * cosLight, 6e4);
}

// Factor on the diffuse albedo for light from all directions: the light that is not reflected specularly. For
// f0 = 0 and f90 = 1 the mean of Schlick's term, weighted by the cosine, is 0.028 (1 - cosEye)^3 with an
// error below 0.001.
mediump vec3 diffuseAlbedoScale(Brdf brdf, vec3 normal) {
    mediump float grazing = 1.0 - clamp(dot(normal, brdf.toEye), 0.0, 1.0);
    return (1.0 - brdf.f0) * (1.0 - 0.028 * brdf.f90 * grazing * grazing * grazing);
}

// The directional albedo of the specular reflection: the integral of the BRDF of appendix B, fitted by least
// squares. `white` is the fit for f0 = 1 with an error below 0.04, `grazing` for f0 = 0 with an error below
// 0.016, for cosines above 0.1.
vec3 specularShare(Brdf brdf, float cosEye) {
    const mat3 lost = mat3(2.5237, -5.1001, 3.0084, -6.6343, 18.2343, -11.2633, 3.246, -9.7958, 6.4822);
    const mat4x2 grows = mat4x2(0.1251, -0.7847, -0.7077, 10.4161, -14.331, 5.7419, 8.9506, -10.0871);
    vec3 r = vec3(1.0, brdf.roughness, brdf.roughness * brdf.roughness);
    vec3 c = vec3(1.0, cosEye, cosEye * cosEye);
    float white = 1.0 - r.z * dot(r, lost * c);
    float grazing = brdf.f90 * pow(1.0 - cosEye, 5.0) * exp2(dot(c.xy, grows * vec4(r, r.y * r.z)));
    return brdf.f0 * (white - grazing) + grazing;
}

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
EmitterHit emittersAlongRay(vec3 start, vec3 direction, float tangent) {
    EmitterHit met = EmitterHit(vec3(0.0), 0.0, 0.0);
    for (int i = 0; i < emitters.count.x; ++i) {
        EmitterPartUniforms part = emitters.part[i];
        float seen = projectedArea(part, direction);
        vec3 offset = part.position.xyz - start / float(frame.gridSide);
        float along = dot(offset, direction);
        // An emitter closer than a voxel is probably the surface itself.
        if (seen <= 0.0 || along * float(frame.gridSide) < 1.0) continue;
        float cone = max(along * tangent, 0.25 / float(frame.gridSide));
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
        met.distance += share * (along - part.radiance.w) * float(frame.gridSide);
    }
    met.distance /= max(met.coverage, 1e-6);
    float most = 1.0 / max(met.coverage, 1.0);
    return EmitterHit(met.radiance * most, met.coverage * most, met.distance);
}
#else
EmitterHit emittersAlongRay(vec3 start, vec3 direction, float tangent) {
    return EmitterHit(vec3(0.0), 0.0, 0.0);
}
#endif

// Traces one cone of a reflection. Samples blend two levels, because neighbouring cones are not averaged and
// whole levels would show as rings. Lengths in voxels.
mediump vec3 traceReflection(vec3 start, vec3 normal, vec3 direction, float tangent) {
    float grid = float(frame.gridSide);
    Cone cone = coneFrom(start, normal, ownFaces(normal, false), direction, true);
    ConeResult result = coneBegin;
    EmitterHit hit = emittersAlongRay(start, direction, tangent);
    while (result.distance < 2.0 * grid) {
        COUNT(VCT_COUNTER_SPECULAR_STEP);
        // The footprint is limited to a quarter of the volume's side.
        float footprint =
            clamp(min(2.0 * result.distance * tangent, heightAt(cone, result.distance)), 1.0, 0.25 * grid);
        // The emitter's light is added before the cone reaches the emitter's own voxels.
        if (hit.coverage > 0.0 && result.distance > hit.distance - footprint) {
            result.radiance = result.radiance + hit.radiance * (result.transmittance / faceRange.radiance);
            result.transmittance = result.transmittance * (1.0 - hit.coverage);
            hit.coverage = 0.0;
        }
        float level = floor(log2(footprint));
        // The cone ends when the wider of the two texels is outside of the volume.
        if (shareInside(positionAt(cone, result.distance), level + 1.0) <= 0.0) break;
        if (addSample(result, cone, level, footprint * exp2(-level) - 1.0, VCT_GATHER_STEP)) break;
    }
    return min(result.radiance * faceRange.radiance, 6e4) +
           result.transmittance * sampleSky(direction, 3.1415927 * tangent * tangent);
}

// The indirect light that a surface at `position` (volume space) reflects specularly, relative to E/pi.
// `gathered`: mean radiance of its hemisphere. The tangent of the cone's half angle is alpha, which is the
// median angle between the normals of the surface and its microfacets (Walter et al. 2007, eq. 35 at one
// half).
mediump vec3 indirectSpecular(Brdf brdf, vec3 position, vec3 normal, mediump vec3 gathered) {
    if (brdf.f90 == 0.0) return vec3(0.0);
    mediump vec3 share = specularShare(brdf, clamp(dot(normal, brdf.toEye), 0.0, 1.0));
    if (brdf.roughness >= roughTo) return share * gathered;
    mediump float rough = smoothstep(roughFrom, roughTo, brdf.roughness);
    vec3 start = position * float(frame.gridSide) + normal * VCT_GATHER_START;
    mediump vec3 met =
        traceReflection(start, normal, reflect(-brdf.toEye, normal), brdf.roughness * brdf.roughness);
    return share * mix(met, gathered, rough);
}
