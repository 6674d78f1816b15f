// glTF's metallic-roughness materials (glTF 2.0, appendix B: GGX of alpha = roughness^2, Schlick's Fresnel term): the sun and other
// lights as they stand there; of what is around, one cone along the mirror direction, and what the surface received.
#include "shared/frame.glsl"
#include "shared/sky.glsl"
#include "directional/cones.glsl"

// From here to there the cone gives way to the gather, whose cones together fit a wide lobe better than one cone does
// (docs/levers.md).
const float roughFrom = 0.3;
const float roughTo = 0.9;

// A material as its pixel shows it.
struct Brdf {
    mediump vec3 diffuse;     // albedo of the light that is not reflected specularly
    mediump vec3 f0;          // Schlick's term head-on
    mediump float roughness;  // from 1 on, nothing is reflected specularly
    vec3 toEye;               // unit length
};

vec3 schlick(vec3 f0, float cosine) {
    return f0 + (1.0 - f0) * pow(1.0 - cosine, 5.0);
}

// Towards the eye, of a light without a size of which a surface that faces it receives the irradiance 1; before its shadow.
vec3 evaluateBrdf(Brdf brdf, vec3 normal, vec3 toLight) {
    float cosLight = dot(normal, toLight);
    if (cosLight <= 0.0) return vec3(0.0);
    if (brdf.roughness >= 1.0) return brdf.diffuse * cosLight;
    float cosEye = max(dot(normal, brdf.toEye), 1e-3);
    vec3 halfway = normalize(toLight + brdf.toEye);
    float cosHalf = max(dot(normal, halfway), 0.0);
    float alpha2 = max(pow(brdf.roughness, 4.0), 1e-6);
    float d = cosHalf * cosHalf * (alpha2 - 1.0) + 1.0;
    float visibility = 1.0 / ((cosLight + sqrt(alpha2 + (1.0 - alpha2) * cosLight * cosLight)) *
                              (cosEye + sqrt(alpha2 + (1.0 - alpha2) * cosEye * cosEye)));
    vec3 fresnel = schlick(brdf.f0, clamp(dot(brdf.toEye, halfway), 0.0, 1.0));
    return min((brdf.diffuse * (1.0 - fresnel) + fresnel * (alpha2 / (d * d) * visibility)) * cosLight, 6e4);
}

// The mean of Schlick's term over the hemisphere, weighted by the cosine, is .028 (1 - cosEye)^3 where f0 is 0, within .001.
mediump vec3 diffuseAlbedoScale(Brdf brdf, vec3 normal) {
    if (brdf.roughness >= 1.0) return vec3(1.0);
    mediump float grazing = 1.0 - clamp(dot(normal, brdf.toEye), 0.0, 1.0);
    return (1.0 - brdf.f0) * (1.0 - 0.028 * grazing * grazing * grazing);
}

// The share of light from all directions that leaves specularly towards the eye: least squares of the integral of appendix B,
// for `white`, of f0 1, and `grazing`, of f0 0. From a cosine of .1 on within .04 of the first and .016 of the second.
vec3 specularShare(vec3 f0, float roughness, float cosEye) {
    const mat3 lost = mat3(2.5237, -5.1001, 3.0084, -6.6343, 18.2343, -11.2633, 3.246, -9.7958, 6.4822);
    const mat4x2 grows = mat4x2(0.1251, -0.7847, -0.7077, 10.4161, -14.331, 5.7419, 8.9506, -10.0871);
    vec3 r = vec3(1.0, roughness, roughness * roughness);
    vec3 c = vec3(1.0, cosEye, cosEye * cosEye);
    float white = 1.0 - r.z * dot(r, lost * c);
    float grazing = pow(1.0 - cosEye, 5.0) * exp2(dot(c.xy, grows * vec4(r, r.y * r.z)));
    return f0 * (white - grazing) + grazing;
}

// The compact emitters that a cone meets, as one at some distance. The voxels do not hold their light.
struct EmitterHit {
    vec3 radiance;  // relative to E/pi, premultiplied by the coverage
    float coverage;
    float distance;  // in voxels, to where the emitters' own voxels begin
};
#ifdef VCT_EMITTERS
#include "shared/emitters.glsl"
// The share of an interval around x, `wide` to each side, that is in another around 0.
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
        // A surface does not reflect the emitter that it belongs to.
        if (seen <= 0.0 || along * float(frame.gridSide) < 1.0) continue;
        float cone = max(along * tangent, 0.25 / float(frame.gridSide));
        float share;
        if (part.side.xyz == vec3(0.0)) {
            // Two discs: the part's, of its own area, and the cone's.
            float disc = sqrt(seen / 3.1415927);
            share = min(disc * disc / (cone * cone), 1.0) *
                    (1.0 - smoothstep(abs(cone - disc), cone + disc, length(offset - along * direction)));
        } else {
            // Of a square as wide as the cone, what is inside of the rectangle, where the cone meets its plane.
            vec3 normal = normalize(part.facing.xyz);
            vec3 place = direction * (dot(offset, normal) / min(dot(direction, normal), -1e-3)) - offset;
            float halfSide = length(part.side.xyz), halfOther = 0.25 * length(part.facing.xyz) / halfSide;
            vec3 side = part.side.xyz / halfSide;
            share = overlap(dot(place, side), halfSide, cone) * overlap(dot(place, cross(normal, side)), halfOther, cone);
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

// One cone along `direction`. Its footprint lies between two levels: nothing averages these cones with their neighbours',
// and whole levels would show as rings and steps. Lengths in voxels.
mediump vec3 traceReflection(vec3 start, vec3 normal, vec3 direction, float tangent) {
    float grid = float(frame.gridSide);
    Cone cone = coneFrom(start, normal, ownFaces(normal, false), direction, true);
    ConeResult result = coneBegin;
    EmitterHit hit = emittersAlongRay(start, direction, tangent);
    while (result.distance < 2.0 * grid) {
        COUNT(VCT_COUNTER_SPECULAR_STEP);
        // A quarter of the volume at most: a cone gets away from the volume faster than it widens.
        float footprint = clamp(min(2.0 * result.distance * tangent, heightAt(cone, result.distance)), 1.0, 0.25 * grid);
        // Its light comes before its own voxels.
        if (hit.coverage > 0.0 && result.distance > hit.distance - footprint) {
            result.radiance = result.radiance + hit.radiance * (result.transmittance / faceRange.radiance);
            result.transmittance = result.transmittance * (1.0 - hit.coverage);
            hit.coverage = 0.0;
        }
        float level = floor(log2(footprint));
        // The wider of the two texels has left the volume.
        if (shareInside(positionAt(cone, result.distance), level + 1.0) <= 0.0) break;
        if (takeSample(result, cone, level, footprint * exp2(-level) - 1.0, VCT_GATHER_STEP)) break;
    }
    return min(result.radiance * faceRange.radiance, 6e4) +
           result.transmittance * sampleSky(direction, 3.1415927 * tangent * tangent);
}

// The light that a surface at `position` (volume space) reflects specularly, but for lights without a size, relative to E/pi.
// `gathered`: the mean of its hemisphere. The cone's half angle has the tangent alpha: the median angle between the surface and its
// microfacets (Walter et al. 2007, eq. 35 at one half).
mediump vec3 indirectSpecular(Brdf brdf, vec3 position, vec3 normal, mediump vec3 gathered) {
    if (brdf.roughness >= 1.0) return vec3(0.0);
    mediump vec3 share = specularShare(brdf.f0, brdf.roughness, clamp(dot(normal, brdf.toEye), 0.0, 1.0));
    if (brdf.roughness >= roughTo) return share * gathered;
    mediump float rough = smoothstep(roughFrom, roughTo, brdf.roughness);
    vec3 start = position * float(frame.gridSide) + normal * VCT_GATHER_START;
    mediump vec3 met = traceReflection(start, normal, reflect(-brdf.toEye, normal), brdf.roughness * brdf.roughness);
    return share * mix(met, gathered, rough);
}
