// The thesis's two cone traces (4.6), with the constants of the published program.
#include "shared/orthonormal.glsl"
#include "shared/counters.glsl"
#include "shared/sky.glsl"
#include "packed/voxel_sample.glsl"

// A cone this opaque is done: eight trilinear weights of a solid sample sum to 1 only up to rounding, which is
// 2^-9 for halves.
const float opaque = 0.998;

// Whether no texel of a level's footprint around `p` lies in the volume. Stopping at p's own crossing would
// cut off samples that still see something, and leave seams in the picture.
bool outsideVolume(vec3 p, int level) {
    vec3 fromCentre = abs(p - 0.5);
    return max(fromCentre.x, max(fromCentre.y, fromCentre.z)) > 0.5 + 0.5 / float(frame.gridSide >> level);
}

const int diffuseConeCount = 6;
// One cone along the normal and five around it at 60 degrees, 60 degrees wide each; y is the normal.
const vec3 diffuseCones[diffuseConeCount] = vec3[diffuseConeCount](
    vec3(0.0, 1.0, 0.0), vec3(0.0, 0.5, 0.866025), vec3(0.823639, 0.5, 0.267617),
    vec3(0.509037, 0.5, -0.700629), vec3(-0.509037, 0.5, -0.700629), vec3(-0.823639, 0.5, 0.267617));
const float diffuseConeSolidAngle = 0.8418;  // 2 pi (1 - cos 30 degrees)
// The cosine is in the weights: 1/4 and 3/20, their sum 1.
const mediump float normalConeWeight = 0.25;
const mediump float ringConeWeight = 0.15;

// Distances in voxels of the finest level. The start clears the surface's own voxels; every step doubles the
// distance and reads the next level, so each step needs one level only (figure 4.5).
const float diffuseStart = 5.0;
const float diffuseFirstSample = 2.5;
const float shadowStart = 8.0;

// `reach` in volume sides: samples beyond it are not taken.
Gather gatherDiffuse(vec3 positionVolume, vec3 normal, float reach) {
    float voxel = 1.0 / float(frame.gridSide);
    vec3 start = positionVolume + normal * (diffuseStart * voxel);
    mat3 volumeFromCone = frameAround(normal);
    Gather gather = Gather(vec3(0.0), 0.0);
    for (int i = 0; i < diffuseConeCount; ++i) {
        COUNT(VCT_COUNTER_DIFFUSE_CONE);
        vec3 direction = volumeFromCone * diffuseCones[i];
        mediump vec3 radiance = vec3(0.0);
        mediump float opacity = 0.0;
        mediump float nearOpacity = 0.0;
        float distance = diffuseFirstSample * voxel;
        for (int level = 0; level <= findMSB(frame.gridSide) && distance < reach && opacity < opaque; ++level) {
            vec3 p = start + direction * distance;
            if (outsideVolume(p, level)) break;
            COUNT(VCT_COUNTER_DIFFUSE_STEP);
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

// By eq. 4.8 a step is the cone's radius. A needle, which would take thousands of them, takes the steps of a
// cone of 2 degrees while they are short, and then half a voxel at a time: at most about 1,000 at 256^3, and no
// wall is stepped over.
float shadowStep(float distance, float radius, float voxel) {
    const float needleRatio = 0.0178;
    return max(radius, min(needleRatio * distance, 0.5 * voxel));
}

// The general cone towards the light (eq. 4.6-4.8): 1 where nothing is in its way.
mediump float traceShadowCone(vec3 positionVolume, vec3 normal) {
    const float furthest = 1.7320508;    // the volume's diagonal, in sides
    float sine = frame.shadowConeSine;
    float ratio = sine / (1.0 - sine);  // eq. 4.8: radius over distance to the sphere's near side
    float side = float(frame.gridSide);
    float voxel = 1.0 / side;
    float lastLevel = float(findMSB(frame.gridSide));
    vec3 start = positionVolume + normal * (shadowStart * voxel);
    float opacity = 0.0;  // highp: near 1 a half would lose the small terms, of which there are a hundred
    for (float distance = voxel; distance < furthest && opacity < opaque;
         distance += shadowStep(distance, ratio * distance, voxel)) {
        float radius = ratio * distance;
        vec3 p = start + frame.directionToLight.xyz * (distance + radius);
        float level = min(log2(max(2.0 * radius * side, 1.0)), lastLevel);  // eq. 4.7
        int fine = int(level);
        if (outsideVolume(p, min(fine + 1, findMSB(frame.gridSide)))) break;
        COUNT(VCT_COUNTER_SHADOW_STEP);
        mediump float blend = level - float(fine);
        mediump float value = sampleOpacity(p, fine);
        if (blend > 0.0) value = mix(value, sampleOpacity(p, fine + 1), blend);
        opacity += value * (1.0 - opacity);
    }
    return clamp(1.0 - opacity, 0.0, 1.0);
}
