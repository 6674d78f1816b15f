// The look-up of irradiance for programs that embed the library, at any point and for any normal
// (GlobalIllumination::lookUpGlsl()). The bindings VCT_LOOK_UP_* are the program's.
#include "shared/layout.h"
#undef VCT_TEX_VOXELS
#undef VCT_TEX_DYNAMIC_VOXELS
#undef VCT_TEX_DYNAMIC_PAGES
#undef VCT_TEX_BLOCKS
#undef VCT_TEX_BRICKS
#undef VCT_TEX_BRICK_PLACES
#undef VCT_TEX_WALLS
#undef VCT_TEX_ENVIRONMENT
#undef VCT_UBO_FRAME
#undef VCT_UBO_EMITTERS
#undef VCT_SSBO_FACES
#define VCT_TEX_VOXELS VCT_LOOK_UP_VOXELS
#define VCT_TEX_DYNAMIC_VOXELS VCT_LOOK_UP_DYNAMIC_VOXELS
#define VCT_TEX_DYNAMIC_PAGES VCT_LOOK_UP_DYNAMIC_PAGES
#define VCT_TEX_BLOCKS VCT_LOOK_UP_BLOCKS
#define VCT_TEX_BRICKS VCT_LOOK_UP_BRICKS
#define VCT_TEX_BRICK_PLACES VCT_LOOK_UP_BRICK_PLACES
#define VCT_TEX_WALLS VCT_LOOK_UP_WALLS
#define VCT_TEX_ENVIRONMENT VCT_LOOK_UP_SKY
#define VCT_UBO_FRAME VCT_LOOK_UP_FRAME
#define VCT_UBO_EMITTERS VCT_LOOK_UP_EMITTERS
#define VCT_SSBO_FACES VCT_LOOK_UP_FACES
#include "directional/ray.glsl"
#include "directional/gather_directions.glsl"
#include "directional/irradiance.glsl"
#include "directional/sky_light.glsl"
#ifdef VCT_EMITTERS
#include "directional/emitter_light.glsl"
#endif

vec3 volumeFromWorld(vec3 positionWorld) {
    return (positionWorld - frame.volumeInWorld.xyz) * frame.volumeInWorld.w;
}

// Irradiance in the air, relative to E, by VCT_GATHER_DIRECTIONS rays and some towards each compact emitter.
// `position` is in volume space.
vec3 irradianceInAir(vec3 position, vec3 normal, int cascade) {
    vec3 start = voxelsFromVolume(position, cascade), light = vec3(0.0);
    mat3 axes = frameAround(normal);
    VisibleSky sky = VisibleSky(0.0);
    for (int i = 0; i < VCT_GATHER_DIRECTIONS; ++i) {
        vec3 aroundNormal = gatherDirection(i), direction = axes * aroundNormal;
        RayHit hit = traceRay(start, cascade, direction, 2.0 * voxelsAlongVolume(cascade),
                              diceOf(i, ivec3(start)), allGeometry);
        if (hit.id == noFace)
            sky += visibleSky(direction, gatherSolidAngle(aroundNormal.y));
        else
            light += faceRadiance(hit.id);
    }
    light = (light + skyLight(sky)) / float(VCT_GATHER_DIRECTIONS);
#ifdef VCT_EMITTERS
    for (int i = 0; i < emitters.count.x; ++i) {
        SeenPart seen = seenPart(emitters.part[i], position, normal);
        if (isStorable(seen.light))
            light += seen.light * visibleShare(emitters.part[i], seen, start, cascade, allGeometry);
    }
#endif
    return light;
}

// Irradiance, premultiplied by coverage, and coverage of the surfaces at a point that face the normal's side.
// It is the first try of irradianceInCascade().
vec4 irradianceOnSurface(vec3 position, vec3 normal, int cascade) {
    vec3 voxel = voxelsFromVolume(position, cascade);
    ivec3 block = ivec3(voxel) >> VCT_BRICK_LEVEL;
    vec4 sum = vec4(0.0), surplus = vec4(0.0);
    bool hasWalls = false;
    for (int axis = 0; axis < 3; ++axis) {
        float weight = normal[axis] * normal[axis];
        vec4 found = irradianceOfBlock(block, axis, normal[axis] > 0.0 ? 0 : 1, positionInBrick(voxel, block),
                                       normal, true, hasWalls);
        sum += weight * found;
        surplus += min(weight, hardlyTowards) * found;
    }
    return hasWalls ? sum - surplus : sum;
}

// Irradiance relative to E by one cascade. It is the stored one where a surface that faces the normal's side
// is near, and of rays elsewhere. `position` is in volume space.
vec3 irradianceByCascade(vec3 position, vec3 normal, int cascade) {
    bool isInside = position == clamp(position, 0.0, 0.9999);
    vec4 stored = isInside ? irradianceOnSurface(position, normal, cascade) : vec4(0.0);
    // With less coverage the surfaces are too far away.
    float share = smoothstep(0.1, 0.4, stored.a);
    vec3 light = share * stored.rgb / max(stored.a, 1e-4);
    return share < 1.0 ? light + (1.0 - share) * irradianceInAir(position, normal, cascade) : light;
}

// Irradiance relative to E. Over the border of two cascades it changes from that of one to that of the other,
// as in sampleIrradiance().
vec3 irradianceAt(vec3 positionWorld, vec3 normal) {
    vec3 position = volumeFromWorld(positionWorld);
    LookUpCascade from = lookUpCascade(position);
    vec3 light = irradianceByCascade(position, normal, from.cascade);
    if (cascades == 1 || from.share == 1.0) return light;
    return mix(irradianceByCascade(position, normal, from.cascade + 1), light, from.share);
}
