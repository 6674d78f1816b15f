// Cones through the directional voxels. Lengths are in voxels of the base level. The constants VCT_GATHER_*
// are the settings of jni/engine/settings.h (GatherSettings).
#include "shared/frame.glsl"
#include "directional/face_range.glsl"
#include "directional/voxels.glsl"
#include "directional/cascades.glsl"
#include "shared/orthonormal.glsl"
#include "shared/counters.glsl"

layout(binding = VCT_TEX_FACES) uniform mediump sampler3D faces;

// Size of a block of faces relative to the texture. Each block covers a whole cascade.
const vec3 blockSize = vec3(1.0 / 3.0, 0.5, 1.0 / float(cascades));

// The texture coordinates of a position (volume space) in the first block of faces of a cascade. `texel`:
// width of the level's texels in voxels of the cascade.
vec3 faceCoordinates(vec3 positionVolume, int cascade, float texel) {
    // The filter must not read texels of the next block.
    float margin = 0.5 * texel / float(frame.gridSide);
    if (cascades == 1) return clamp(positionVolume, margin, 1.0 - margin) * blockSize;
    vec4 cube = frame.cascade[cascade];
    vec3 p = (positionVolume - cube.xyz) * (cube.w / float(frame.gridSide));
    return (clamp(p, margin, 1.0 - margin) + vec3(0.0, 0.0, float(cascade))) * blockSize;
}

// Premultiplied radiance and coverage of the faces that a ray meets around a position (volume space) at a
// whole mip level of a cascade. These are the faces opposite to the ray's direction, one per axis. `share`:
// component of the direction along each axis; 0 excludes the axis.
//
// A face covers the ray by its component, so that three faces of a corner cover it by up to 1.73. Radiance is
// weighted by the square, as in an ambient cube (McTaggart 2004, "Half-Life 2 / Valve Source Shading"). A
// face that the ray meets at a slant may be lit on a side of a round object that the ray does not see.
mediump vec4 sampleFaces(vec3 position, vec3 direction, mediump vec3 share, int cascade, float level) {
    vec3 p = faceCoordinates(position, cascade, exp2(level));
    vec3 side = mix(vec3(0.0), vec3(blockSize.y), greaterThan(direction, vec3(0.0)));
    mediump vec4 x = textureLod(faces, p + vec3(0.0, side.x, 0.0), level);
    mediump vec4 y = textureLod(faces, p + vec3(blockSize.x, side.y, 0.0), level);
    mediump vec4 z = textureLod(faces, p + vec3(2.0 * blockSize.x, side.z, 0.0), level);
    mediump vec3 square = share * share;
    mediump vec4 shining = square.x * x + square.y * y + square.z * z;
    mediump float coverage = dot(share, vec3(x.a, y.a, z.a));
    return vec4(shining.rgb * (coverage / max(shining.a, 1e-4)), coverage);
}

// A cone from a point near a surface. Lengths and levels are in voxels of the surface's cascade.
struct Cone {
    vec3 start;
    int cascade;
    vec3 direction;  // unit length
    vec3 normal;     // the surface's
    vec3 ownBelow;   // ownFaces()
    float rise;      // height above the surface's plane per distance
    // Samples fade out over one texel across the volume's border. Otherwise the cone ends at the border, and
    // loses up to half of a wall that lies on it.
    bool fades;
};

Cone coneFrom(vec3 start, int cascade, vec3 normal, vec3 ownBelow, vec3 direction, bool fades) {
    return Cone(start, cascade, direction, normal, ownBelow, dot(direction, normal), fades);
}

float heightAt(Cone cone, float distance) {
    return VCT_GATHER_START + distance * cone.rise;
}

// The position at a distance, in volume space.
vec3 positionAt(Cone cone, float distance) {
    return volumeFromVoxels(cone.start + cone.direction * distance, cone.cascade);
}

struct ConeResult {
    float distance;         // to the next sample
    mediump vec3 radiance;  // relative to E/pi; divided by faceRange.radiance until coneEnd()
    mediump float transmittance;
    mediump float nearness;  // sum of 1 / distance over the samples, weighted by opacity
};

const ConeResult coneBegin = ConeResult(VCT_GATHER_FIRST_SAMPLE, vec3(0.0), 1.0, 0.0);

// Opacity of a fully covered sample. Samples are VCT_GATHER_STEP footprints apart, so one sample stands for
// that length.
const mediump float sampleOpacity = VCT_GATHER_EXTINCTION * VCT_GATHER_STEP;

// For each axis: a ray near its surface ignores the axis if its direction times the normal is less than this.
// The faces of the surface itself look towards its normal, so 0 excludes them. If the surface has a back, as
// a sheet or a thin plate has, faces of both sides are excluded: no direction reaches 2.
vec3 ownFaces(vec3 normal, bool hasBack) {
    return hasBack ? 2.0 * step(0.3, abs(normal)) : vec3(0.0);
}

// The share of a texel around a position (volume space) that is inside of the volume. Not limited to 0..1.
// `level`: of the texel in a cascade.
float shareInside(vec3 position, int cascade, float level) {
    vec3 fromCentre = abs(position - 0.5);
    return voxelsAlongVolume(cascade) * exp2(-level) *
               (0.5 - max(fromCentre.x, max(fromCentre.y, fromCentre.z))) +
           0.5;
}

// Premultiplied radiance and coverage that a cone meets at a distance, at one level of a cascade.
mediump vec4 sampleLevel(Cone cone, float distance, vec3 position, int cascade, float level) {
    // A slanted surface has faces along several axes, and a ray that leaves it would meet some of them.
    bool isNear = heightAt(cone, distance) < VCT_GATHER_OWN_SURFACE * exp2(level);
    bvec3 own = lessThan(cone.direction * cone.normal, isNear ? cone.ownBelow : vec3(-1.0));
    mediump vec4 met = sampleFaces(position, cone.direction, mix(abs(cone.direction), vec3(0.0), own),
                                   cascade, level + float(cone.cascade - cascade));
    return cone.fades ? met * clamp(shareInside(position, cone.cascade, level), 0.0, 1.0) : met;
}

// Adds the cone's next sample and advances by one step. Returns true if the cone ends. `opacity`: opacity of
// a fully covered sample.
bool addSample(inout ConeResult result, Cone cone, float level, mediump float opacity) {
    float distance = result.distance;
    vec3 position = positionAt(cone, distance);
    int cascade = cascadeOfSample(position, cone.cascade, level);
    level = max(level, float(cascade - cone.cascade));
    result.distance += VCT_GATHER_STEP * exp2(level);
    mediump vec4 met = sampleLevel(cone, distance, position, cascade, level);
    // Opacities are added up to the transmittance, because multiplied transmittances let too much light
    // through. A cone that meets several faces of a corner is covered once.
    mediump float taken = min(opacity * min(met.a, 1.0), result.transmittance);
    result.radiance = result.radiance + met.rgb * (taken / max(met.a, 1e-4));
    result.transmittance = result.transmittance - taken;
    result.nearness = result.nearness + taken / distance;
    return result.transmittance < VCT_GATHER_THRESHOLD;
}

// The result of all samples. If the cone ended early, the rest of it is assumed to meet the same radiance.
ConeResult coneEnd(ConeResult result) {
    mediump float met = 1.0 - result.transmittance;
    bool ended = result.transmittance < VCT_GATHER_THRESHOLD;
    result.radiance = result.radiance * (faceRange.radiance / (ended ? met : 1.0));
    if (ended) result.transmittance = 0.0;
    return result;
}

// The level for a gather's sample at a height above the plane of its surface, in voxels. The footprint grows
// with the height because a wider sample would contain the surface. Levels are whole, because a wall's
// coverage adds up to 1 over the samples only if the footprint is one texel.
float levelAt(float height, float spread) {
    return max(floor(log2(VCT_GATHER_HEIGHT * spread * height)), 0.0);
}

// Traces one cone of a gather from its sample at the distance `begin` up to `reach`. `spread` scales its
// width. `cascade`: of the surface.
ConeResult traceCone(vec3 start, int cascade, vec3 normal, vec3 ownBelow, vec3 direction, float begin,
                     float reach, float spread) {
    Cone cone = coneFrom(start, cascade, normal, ownBelow, direction, VCT_GATHER_FADES);
    ConeResult result = coneBegin;
    result.distance = begin;
    float level = levelAt(heightAt(cone, result.distance), spread);
    if (!VCT_GATHER_FADES) {
        // The cone ends where it leaves the volume.
        vec3 away = (voxelsFromVolume(step(0.0, direction), cascade) - start) / direction;
        reach = min(reach, min(away.x, min(away.y, away.z)));
    }
    while (result.distance < reach) {
        COUNT(VCT_COUNTER_IRRADIANCE_STEP);
        if (cone.fades && shareInside(positionAt(cone, result.distance), cascade, level) <= 0.0) break;
        float next =
            levelAt(heightAt(cone, result.distance) + VCT_GATHER_STEP * exp2(level) * cone.rise, spread);
        // Before the level rises, this sample and the next, wider one overlap.
        if (addSample(result, cone, level, (next > level ? VCT_GATHER_LEVEL_END : 1.0) * sampleOpacity))
            break;
        level = next;
    }
    return coneEnd(result);
}
