// Cones through the directional coverage voxels. Lengths in voxels of the finest level. The constants come from
// the settings (jni/engine/settings.h: GatherSettings), as VCT_GATHER_*. VCT_CONE_COUNTER: what counts their steps.
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

struct ConeResult {
    mediump vec3 radiance;        // relative to E/pi
    mediump float transmittance;  // what is left
    mediump float nearness;       // 1 / distance of what it met, in voxels, and 0 of what is left
};

// Of a sample: those of neighbours are a step apart, and overlap or gap by as much.
const mediump float sampleOpacity = VCT_GATHER_EXTINCTION * VCT_GATHER_STEP;

// Which faces near a surface are its own, for traceCone(): a ray whose direction times the normal is less than this along an
// axis does not meet that axis's faces. Those of the surface itself look to its normal's side; those of its back, if it is a
// sheet seen from both sides or a thin plate, to the other, and any direction goes below 2.
vec3 ownFaces(vec3 normal, bool hasBack) {
    return hasBack ? 2.0 * step(0.3, abs(normal)) : vec3(0.0);
}

// Level whose texels are as wide as a cone at that height above the plane of the surface that it starts from, in voxels: a
// wider sample would contain that surface. Whole levels: a wall's coverage sums to 1 over samples that are a texel apart,
// only if the texel's size is the footprint.
float levelAt(float height, float spread) {
    return max(floor(log2(VCT_GATHER_HEIGHT * spread * height)), 0.0);
}

// One cone from a point near a surface with that normal; `ownBelow`: ownFaces(). Samples beyond `reach` are not taken. Lengths
// in voxels. `spread`: scales its width.
ConeResult traceCone(vec3 start, vec3 normal, vec3 ownBelow, vec3 direction, float reach, float spread) {
    float grid = float(frame.gridSide);
    ConeResult result = ConeResult(vec3(0.0), 1.0, 0.0);
    float distance = VCT_GATHER_FIRST_SAMPLE;
    float rise = dot(direction, normal);
    float level = levelAt(VCT_GATHER_START + distance * rise, spread);
    if (!VCT_GATHER_FADES) {
        // Where it leaves the volume (in the far corner's or the near one's planes).
        vec3 away = (step(0.0, direction) * grid - start) / direction;
        reach = min(reach, min(away.x, min(away.y, away.z)));
    }
    while (distance < reach) {
        COUNT(VCT_CONE_COUNTER);
        float height = VCT_GATHER_START + distance * rise;
        float stride = VCT_GATHER_STEP * exp2(level);
        float next = levelAt(height + stride * rise, spread);
        // Faces are one-sided along the axes only: near its surface the ray would meet those that are the surface's own.
        bvec3 own = lessThan(direction * normal, height < VCT_GATHER_OWN_SURFACE * exp2(level) ? ownBelow : vec3(-1.0));
        mediump vec3 share = mix(abs(direction), vec3(0.0), own);
        vec3 position = (start + direction * distance) / grid;
        mediump vec4 met = sampleFaces(position, direction, share, level);
        if (VCT_GATHER_FADES) {
            // Beyond the volume there is nothing: in the half texels on both sides of its border the border's texel fades
            // into that. Of a wall on the border a cone that is cut off there loses up to half.
            vec3 fromCentre = abs(position - 0.5);
            float inside = grid * exp2(-level) * (0.5 - max(fromCentre.x, max(fromCentre.y, fromCentre.z))) + 0.5;
            if (inside <= 0.0) break;
            met *= min(inside, 1.0);
        }
        // The next sample is wider than it is far away where the level rises: the two share what is between them.
        mediump float opacity = (next > level ? VCT_GATHER_LEVEL_END : 1.0) * sampleOpacity;
        // Added, and cut off at what is left: multiplied transmittances let too much through.
        mediump float taken = min(opacity * min(met.a, 1.0), result.transmittance);
        result.radiance = result.radiance + met.rgb * (taken / max(met.a, 1e-4));
        result.transmittance = result.transmittance - taken;
        result.nearness = result.nearness + taken / distance;
        if (result.transmittance < VCT_GATHER_THRESHOLD) break;
        distance += stride;
        level = next;
    }
    // A cone that ended early met, in the rest, what it met before.
    mediump float met = 1.0 - result.transmittance;
    bool ended = result.transmittance < VCT_GATHER_THRESHOLD;
    result.radiance = result.radiance * (faceRange.radiance / (ended ? met : 1.0));
    if (ended) result.transmittance = 0.0;
    return result;
}
