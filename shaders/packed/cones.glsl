// The thesis's two kinds of cones (4.6), for diffuse light and for the shadow, with the constants of its
// published program.
#include "shared/orthonormal.glsl"
#include "shared/sky.glsl"
#include "packed/voxel_sample.glsl"

// A cone ends at this opacity. The eight trilinear weights of a solid sample add up to 1 only up to
// rounding, which is 2^-9 for half floats.
const float opaque = 0.998;

// True if all texels around `p` at a level are outside of the volume. If the test used only p itself, cones
// would lose samples that still have occupied texels, which shows as seams.
bool outsideVolume(vec3 p, int level) {
    vec3 fromCentre = abs(p - 0.5);
    return max(fromCentre.x, max(fromCentre.y, fromCentre.z)) > 0.5 + 0.5 / float(frame.gridSide >> level);
}

const int diffuseConeCount = 6;
// One cone along the normal (y) and five around it at 60 degrees; each is 60 degrees wide.
const vec3 diffuseCones[diffuseConeCount] = vec3[diffuseConeCount](
    vec3(0.0, 1.0, 0.0), vec3(0.0, 0.5, 0.866025), vec3(0.823639, 0.5, 0.267617),
    vec3(0.509037, 0.5, -0.700629), vec3(-0.509037, 0.5, -0.700629), vec3(-0.823639, 0.5, 0.267617));
const float diffuseConeSolidAngle = 0.8418;  // 2 pi (1 - cos 30 degrees)
// The weights 1/4 and 3/20 include the cosine. They add up to 1.
const mediump float normalConeWeight = 0.25;
const mediump float ringConeWeight = 0.15;

// Distances in voxels of the finest level. Cones start outside of the surface's own voxels. Each step doubles
// the distance and reads the next level, so that each sample needs one level only (figure 4.5).
const float diffuseStart = 5.0;
const float diffuseFirstSample = 2.5;
const float shadowStart = 8.0;

// Gathers light and ambient visibility. Cones end at the distance `reach`, in sides of the volume.
Gather gatherDiffuse(vec3 positionVolume, vec3 normal, float reach) {
    float voxel = 1.0 / float(frame.gridSide);
    vec3 start = positionVolume + normal * (diffuseStart * voxel);
    mat3 volumeFromCone = frameAround(normal);
    Gather gather = Gather(vec3(0.0), 0.0);
    for (int i = 0; i < diffuseConeCount; ++i) {
        vec3 direction = volumeFromCone * diffuseCones[i];
        mediump vec3 radiance = vec3(0.0);
        mediump float opacity = 0.0;
        mediump float nearOpacity = 0.0;
        float distance = diffuseFirstSample * voxel;
        for (int level = 0; level <= findMSB(frame.gridSide) && distance < reach && opacity < opaque;
             ++level) {
            vec3 p = start + direction * distance;
            if (outsideVolume(p, level)) break;
            mediump vec4 value = sampleVoxels(p, level) * (1.0 - opacity);
            radiance = radiance + value.rgb;
            opacity = opacity + value.a;
            if (distance < frame.aoDistance) nearOpacity = opacity;
            distance *= 2.0;
        }
        mediump float weight = i == 0 ? normalConeWeight : ringConeWeight;
        mediump vec3 sky = max(1.0 - opacity, 0.0) * sampleSky(direction, diffuseConeSolidAngle);
        gather.radiance = gather.radiance + weight * (radiance + sky);
        gather.ambientVisibility = gather.ambientVisibility + weight * max(1.0 - nearOpacity, 0.0);
    }
    return gather;
}

// The step after a sample: the cone's radius (eq. 4.8). A very narrow cone would need thousands of steps, so
// steps are at least those of a cone of 2 degrees, up to half a voxel. That is at most about 1,000 steps at
// 256^3, and no step skips a wall.
float shadowStep(float distance, float radius, float voxel) {
    const float needleRatio = 0.0178;
    return max(radius, min(needleRatio * distance, 0.5 * voxel));
}

// Traces the general cone towards the sun (eq. 4.6-4.8) and returns its transmittance: 1 in light, 0 in
// shadow.
mediump float traceShadowCone(vec3 positionVolume, vec3 normal) {
    const float furthest = 1.7320508;  // the volume's diagonal, in sides
    float sine = frame.shadowConeSine;
    float ratio = sine / (1.0 - sine);  // eq. 4.8: radius over distance to the sphere's near side
    float side = float(frame.gridSide);
    float voxel = 1.0 / side;
    float lastLevel = float(findMSB(frame.gridSide));
    vec3 start = positionVolume + normal * (shadowStart * voxel);
    float opacity = 0.0;  // highp, because a half float near 1 would lose the hundred small terms
    for (float distance = voxel; distance < furthest && opacity < opaque;
         distance += shadowStep(distance, ratio * distance, voxel)) {
        float radius = ratio * distance;
        vec3 p = start + frame.directionToLight.xyz * (distance + radius);
        float level = min(log2(max(2.0 * radius * side, 1.0)), lastLevel);  // eq. 4.7
        int fine = int(level);
        if (outsideVolume(p, min(fine + 1, findMSB(frame.gridSide)))) break;
        mediump float blend = level - float(fine);
        mediump float value = sampleOpacity(p, fine);
        if (blend > 0.0) value = mix(value, sampleOpacity(p, fine + 1), blend);
        opacity += value * (1.0 - opacity);
    }
    return clamp(1.0 - opacity, 0.0, 1.0);
}
