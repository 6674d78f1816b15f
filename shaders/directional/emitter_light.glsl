// The light of the compact emitters at a point: a closed form gives the share of the hemisphere that a part
// of an emitter fills, and a cone towards the part gives its visibility (next event estimation).
#include "directional/cones.glsl"
#include "shared/emitters.glsl"

// Width of a cone relative to its part. A cone as wide as the part would meet surfaces beside it.
const float emitterConeWidth = 0.25;
// The smallest positive half float.
const float minStoredLight = 6e-8;

// A part as a point sees it.
struct SeenPart {
    vec3 towards;    // unit length
    float distance;  // to its middle, in sides of the volume
    float area;      // projected, in squared sides of the volume
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
    return SeenPart(towards, distance, area, part.radiance.rgb * share);
}

bool isStorable(vec3 light) {
    return max(light.r, max(light.g, light.b)) >= minStoredLight;
}

// A cone's transmittance at the distance `reach`, in voxels. `tangent`: tangent of its half angle.
mediump float transmittanceTo(Cone cone, float reach, float tangent) {
    ConeResult result = coneBegin;
    while (result.distance < reach) {
        COUNT(VCT_COUNTER_EMITTERS_STEP);
        // Samples narrow again towards the emitter, so that they do not meet it.
        float widest =
            min(VCT_GATHER_HEIGHT * heightAt(cone, result.distance), 0.5 * (reach - result.distance));
        float level = floor(log2(max(min(2.0 * result.distance * tangent, widest), 1.0)));
        // The last sample counts in proportion to its part before the end.
        mediump float within = min((reach - result.distance) / (VCT_GATHER_STEP * exp2(level)), 1.0);
        if (addSample(result, cone, level, within * sampleOpacity)) break;
    }
    return coneEnd(result).transmittance;
}

// The part's light at the point. The rest of the arguments: as of coneFrom().
vec3 lightOfPart(EmitterPartUniforms part, SeenPart seen, vec3 start, int cascade, vec3 normal,
                 vec3 ownBelow) {
    // A cone at a grazing angle to a flat part is near its voxels, and its support's, for longer.
    float rising = clamp(seen.area / (length(part.facing.xyz) + part.facing.w), 0.25, 1.0);
    float reach = (seen.distance - endOfCones(part) / rising) * voxelsAlongVolume(cascade);
    Cone cone = coneFrom(start, cascade, normal, ownBelow, seen.towards, false);
    return seen.light * transmittanceTo(cone, reach, emitterConeWidth * part.position.w / seen.distance);
}
