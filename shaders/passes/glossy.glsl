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

// Where a ray meets the faces of a corner, it is covered once. Beyond the volume there is nothing: in the half texels on
// both sides of its border the border's texel fades into that. Without it, a wall on the border counts for one sample more or
// less from ray to ray, and its reflection has hard edges.
mediump vec4 sampleCovered(vec3 position, vec3 direction, float level) {
    mediump vec4 value = sampleFaces(position, direction, abs(direction), level);
    float texels = float(frame.gridSide) * exp2(-level);
    vec3 inside = clamp(texels * (0.5 - abs(position - 0.5)) + 0.5, 0.0, 1.0);
    return value * (inside.x * inside.y * inside.z / max(value.a, 1.0));
}

// Radiance (premultiplied) and coverage of one sample between two mip levels. Each level is weighed by its own texel:
// then a wall's coverage sums to 1 over the samples that pass it. Lengths in voxels.
mediump vec4 sampleBetween(vec3 position, vec3 direction, float footprint, float stride) {
    float level = floor(log2(footprint));
    float texel = exp2(level);
    float part = footprint / texel - 1.0;
    mediump vec4 value = sampleCovered(position, direction, level) * (stride / texel);
    if (part > 0.0)
        value = mix(value, sampleCovered(position, direction, level + 1.0) * (0.5 * stride / texel), part);
    return value;
}

// What a cone meets of lamps, whose light the voxels do not hold: all of them as one, some way along it.
struct LampsMet {
    vec3 radiance;  // relative to E/pi, premultiplied by the coverage
    float coverage;
    float distance;  // in voxels, to where their own voxels begin
};
#ifdef VCT_EMITTERS
#include "shared/emitters.glsl"
// The share of an interval around x, `wide` to each side, that is in another around 0.
float overlap(float x, float halfSide, float wide) {
    return clamp((min(x + wide, halfSide) - max(x - wide, -halfSide)) / (2.0 * wide), 0.0, 1.0);
}
LampsMet lampsAlong(vec3 start, vec3 direction, float tangent) {
    LampsMet met = LampsMet(vec3(0.0), 0.0, 0.0);
    for (int i = 0; i < emitters.count.x; ++i) {
        EmitterPartUniforms part = emitters.part[i];
        float seen = seenArea(part, direction);
        vec3 offset = part.place.xyz - start / float(frame.gridSide);
        float along = dot(offset, direction);
        // Of itself a lamp reflects nothing.
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
    return LampsMet(met.radiance * most, met.coverage * most, met.distance);
}
#else
LampsMet lampsAlong(vec3 start, vec3 direction, float tangent) {
    return LampsMet(vec3(0.0), 0.0, 0.0);
}
#endif

// One cone along `direction`, as traceCone of directional/cones.glsl, whose whole levels and small footprints would
// show as rings and steps: nothing averages these cones with their neighbours'. Lengths in voxels.
mediump vec3 traceReflection(vec3 start, vec3 normal, vec3 direction, float tangent) {
    float voxel = 1.0 / float(frame.gridSide);
    float widest = 0.25 * float(frame.gridSide);  // so that a cone gets away from the volume faster than it widens
    mediump vec3 radiance = vec3(0.0), ofLamps = vec3(0.0);
    mediump float transmittance = 1.0;
    LampsMet lamps = lampsAlong(start, direction, tangent);
    vec3 own = max(-direction * normal, 0.0);
    float distance = VCT_GATHER_FIRST_SAMPLE + VCT_GATHER_OWN_SURFACE * (own.x + own.y + own.z);
    // The volume's diagonal in the shortest steps: a bound for the driver, never reached.
    for (int i = 0; i < 1024; ++i) {
        vec3 p = (start + direction * distance) * voxel;
        COUNT(VCT_COUNTER_SPECULAR_STEP);
        float height = VCT_GATHER_START + distance * dot(direction, normal);
        float footprint = clamp(min(2.0 * distance * tangent, height), 1.0, widest);
        // The coarser texel is two footprints wide at most.
        vec3 fromCentre = abs(p - 0.5);
        if (max(fromCentre.x, max(fromCentre.y, fromCentre.z)) > 0.5 + footprint * voxel) break;
        // Before the voxels of the lamps themselves.
        if (lamps.coverage > 0.0 && distance > lamps.distance - footprint) {
            ofLamps = lamps.radiance * transmittance;
            transmittance = transmittance * (1.0 - lamps.coverage);
            lamps.coverage = 0.0;
        }
        float stride = VCT_GATHER_STEP * footprint;
        mediump vec4 value = sampleBetween(p, direction, footprint, stride);
        mediump float share = min(1.0, transmittance / max(value.a, 1e-4));
        radiance = radiance + value.rgb * share;
        transmittance = transmittance - value.a * share;
        if (transmittance < VCT_GATHER_THRESHOLD) break;
        distance += stride;
    }
    return radiance * faceRange.radiance + min(ofLamps, 6e4) + transmittance * skyTowards(direction, 3.1415927 * tangent * tangent);
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
