// Cones through the directional coverage voxels. Lengths in voxels of the finest level. The constants come from
// the settings (jni/engine/settings.h: GatherSettings), as VCT_GATHER_*.
#include "shared/frame.glsl"
#include "directional/face_range.glsl"
#include "directional/voxels.glsl"
#include "shared/orthonormal.glsl"
#include "shared/counters.glsl"

layout(binding = VCT_TEX_FACES) uniform mediump sampler3D faces;

// Of the volume in the texture: each block of faces is one.
const vec3 blockSize = vec3(1.0 / 3.0, 0.5, 1.0);

// Radiance (premultiplied) and coverage that a ray meets around a position (volume space) at a whole mip level: of the
// faces that look against its direction; `share`: that of each axis in it. Coverage up to 1.73, where it meets three faces
// of a corner. Each face covers its projection, the ray's share of its axis; but shines by the square of that, as an ambient
// cube (McTaggart 2004, "Half-Life 2 / Valve Source Shading"): what a ray meets at a slant may be the far side of something
// round, lit where the ray cannot see.
mediump vec4 sampleFaces(vec3 position, vec3 direction, mediump vec3 share, float level) {
    // No texel of the next block may leak in.
    float margin = 0.5 * exp2(level) / float(frame.gridSide);
    vec3 p = clamp(position, margin, 1.0 - margin) * blockSize;
    vec3 side = mix(vec3(0.0), vec3(blockSize.y), greaterThan(direction, vec3(0.0)));
    mediump vec4 x = textureLod(faces, p + vec3(0.0, side.x, 0.0), level);
    mediump vec4 y = textureLod(faces, p + vec3(blockSize.x, side.y, 0.0), level);
    mediump vec4 z = textureLod(faces, p + vec3(2.0 * blockSize.x, side.z, 0.0), level);
    mediump vec3 square = share * share;
    mediump vec4 shining = square.x * x + square.y * y + square.z * z;
    mediump float coverage = dot(share, vec3(x.a, y.a, z.a));
    return vec4(shining.rgb * (coverage / max(shining.a, 1e-4)), coverage);
}

// A cone from a point near a surface. Lengths in voxels.
struct Cone {
    vec3 start;
    vec3 direction;  // unit length
    vec3 normal;     // of the surface
    vec3 ownBelow;   // ownFaces()
    float rise;      // height above the surface's plane per distance
    // The border's texels fade into the nothing behind them, over half a texel on both sides of the volume's border.
    // A cone that is cut off at the border loses up to half of a wall that stands there.
    bool fades;
};

Cone coneFrom(vec3 start, vec3 normal, vec3 ownBelow, vec3 direction, bool fades) {
    return Cone(start, direction, normal, ownBelow, dot(direction, normal), fades);
}

float heightAt(Cone cone, float distance) {
    return VCT_GATHER_START + distance * cone.rise;
}

// The position in volume space at a distance.
vec3 positionAt(Cone cone, float distance) {
    return (cone.start + cone.direction * distance) / float(frame.gridSide);
}

struct ConeResult {
    float distance;               // of the next sample
    mediump vec3 radiance;        // relative to E/pi, over faceRange.radiance while the cone is traced
    mediump float transmittance;
    mediump float nearness;       // the sum of 1 / distance over what the cone met
};

const ConeResult coneBegin = ConeResult(VCT_GATHER_FIRST_SAMPLE, vec3(0.0), 1.0, 0.0);

// Opacity of a gather's sample that is covered: samples of neighbours are a step apart, and overlap or gap by as much.
const mediump float sampleOpacity = VCT_GATHER_EXTINCTION * VCT_GATHER_STEP;

// A ray near a surface does not meet the surface's own faces: those of an axis along which its direction times the normal is
// less than this. The faces of the surface look to its normal's side; those of its back, if it is a sheet seen from both sides
// or a thin plate, to the other, and any direction is less than 2.
vec3 ownFaces(vec3 normal, bool hasBack) {
    return hasBack ? 2.0 * step(0.3, abs(normal)) : vec3(0.0);
}

// The share of a texel of that level around a position (volume space) that is inside of the volume; from 1 on all of it.
float shareInside(vec3 position, float level) {
    vec3 fromCentre = abs(position - 0.5);
    return float(frame.gridSide) * exp2(-level) * (0.5 - max(fromCentre.x, max(fromCentre.y, fromCentre.z))) + 0.5;
}

// Radiance (premultiplied) and coverage that a cone meets at a distance, in texels of one level.
mediump vec4 sampleLevel(Cone cone, float distance, vec3 position, float level) {
    // Faces are one-sided along the axes only: near its surface the ray would meet those that are the surface's own.
    bool isNear = heightAt(cone, distance) < VCT_GATHER_OWN_SURFACE * exp2(level);
    bvec3 own = lessThan(cone.direction * cone.normal, isNear ? cone.ownBelow : vec3(-1.0));
    mediump vec4 met = sampleFaces(position, cone.direction, mix(abs(cone.direction), vec3(0.0), own), level);
    return cone.fades ? met * clamp(shareInside(position, level), 0.0, 1.0) : met;
}

// Adds the cone's next sample and advances by one step; true where the cone ends. `blend`: the sample's place between the
// level and the next, which makes the footprint (1 + blend) texels wide. `opacity`: of a covered sample that is a texel wide.
bool takeSample(inout ConeResult result, Cone cone, float level, mediump float blend, mediump float opacity) {
    float distance = result.distance;
    vec3 position = positionAt(cone, distance);
    result.distance += VCT_GATHER_STEP * exp2(level) * (1.0 + blend);
    mediump vec4 met = sampleLevel(cone, distance, position, level);
    if (blend > 0.0) {
        // Each level is weighed by its own texel: then a wall's coverage sums to 1 over the samples that pass it.
        mediump vec4 wider = sampleLevel(cone, distance, position, level + 1.0);
        met = mix(met / max(met.a, 1.0), wider * (0.5 / max(wider.a, 1.0)), blend);
    }
    // Opacity is added, and cut off at the transmittance: multiplied transmittances let too much through. A cone that meets
    // the faces of a corner is covered once.
    mediump float taken = min(opacity * (1.0 + blend) * min(met.a, 1.0), result.transmittance);
    result.radiance = result.radiance + met.rgb * (taken / max(met.a, 1e-4));
    result.transmittance = result.transmittance - taken;
    result.nearness = result.nearness + taken / distance;
    return result.transmittance < VCT_GATHER_THRESHOLD;
}

// The result of all samples. A cone that ended early met, in the rest, what it met before.
ConeResult coneEnd(ConeResult result) {
    mediump float met = 1.0 - result.transmittance;
    bool ended = result.transmittance < VCT_GATHER_THRESHOLD;
    result.radiance = result.radiance * (faceRange.radiance / (ended ? met : 1.0));
    if (ended) result.transmittance = 0.0;
    return result;
}

// Level whose texels are as wide as a gather's cone at that height above the plane of the surface that it starts from, in
// voxels: a wider sample would contain that surface. Whole levels: a wall's coverage sums to 1 over samples that are a texel
// apart, only if the texel's size is the footprint.
float levelAt(float height, float spread) {
    return max(floor(log2(VCT_GATHER_HEIGHT * spread * height)), 0.0);
}

// One cone of a gather. Samples beyond `reach` are not taken. `spread`: scales its width.
ConeResult traceCone(vec3 start, vec3 normal, vec3 ownBelow, vec3 direction, float reach, float spread) {
    Cone cone = coneFrom(start, normal, ownBelow, direction, VCT_GATHER_FADES);
    ConeResult result = coneBegin;
    float level = levelAt(heightAt(cone, result.distance), spread);
    if (!VCT_GATHER_FADES) {
        // The cone leaves the volume through a plane of its far corner or its near one.
        vec3 away = (step(0.0, direction) * float(frame.gridSide) - start) / direction;
        reach = min(reach, min(away.x, min(away.y, away.z)));
    }
    while (result.distance < reach) {
        COUNT(VCT_COUNTER_IRRADIANCE_STEP);
        if (cone.fades && shareInside(positionAt(cone, result.distance), level) <= 0.0) break;
        float next = levelAt(heightAt(cone, result.distance) + VCT_GATHER_STEP * exp2(level) * cone.rise, spread);
        // The next sample is wider than it is far away where the level rises: the two share the space between them.
        if (takeSample(result, cone, level, 0.0, (next > level ? VCT_GATHER_LEVEL_END : 1.0) * sampleOpacity)) break;
        level = next;
    }
    return coneEnd(result);
}
