// Cones through the directional coverage voxels. Lengths in voxels of the finest level. The constants come from
// the settings (jni/render/settings.h: Gather), as VCT_GATHER_*. VCT_CONE_TRIPS: what counts their steps.
#include "shared/blocks.glsl"
#include "shared/face_voxels.glsl"
#include "shared/orthonormal.glsl"
#include "shared/precision.glsl"
#include "shared/trips.glsl"

layout(binding = VCT_TEX_FACES) uniform mediump sampler3D faces;

// A direction, and what sampling along it needs: each axis's share, and the side of the faces that look against it.
struct Ray {
    vec3 direction;
    vec3 share;
    vec3 side;  // in texture coordinates
};

Ray rayAlong(vec3 direction) {
    return Ray(direction, abs(direction), mix(vec3(0.0), vec3(0.5), greaterThan(direction, vec3(0.0))));
}

// Radiance (premultiplied) and coverage that the ray meets around a position (volume space) at a whole mip level.
mediump vec4 sampleFaces(vec3 position, Ray ray, float level) {
    // No texel of the next block may leak in.
    float margin = 0.5 * exp2(level) / float(frame.grid.x);
    vec3 p = clamp(position, margin, 1.0 - margin) * vec3(1.0 / 3.0, 0.5, 1.0);
    mediump vec4 value = HALF(ray.share.x * textureLod(faces, p + vec3(0.0, ray.side.x, 0.0), level) +
                              ray.share.y * textureLod(faces, p + vec3(1.0 / 3.0, ray.side.y, 0.0), level) +
                              ray.share.z * textureLod(faces, p + vec3(2.0 / 3.0, ray.side.z, 0.0), level));
    return HALF(value / max(value.a, 1.0));
}

// Cone i of the set around a normal along +y, with its cosine in y: a Fibonacci set, whose equal weights contain the
// cosine of the gather; the golden angle from one to the next, all turned by `turn` (of a whole turn).
vec3 gatherCone(int i, float turn) {
    float fraction = (float(i) + 0.5) / float(VCT_GATHER_CONES);
    float phi = 6.2831853 * fract(0.381966 * float(i) + turn);
    return vec3(sqrt(fraction) * cos(phi), sqrt(1.0 - fraction), sqrt(fraction) * sin(phi));
}

struct ConeResult {
    mediump vec3 radiance;        // relative to E/pi
    mediump float transmittance;  // what is left
};

const float finestFootprint = exp2(float(VCT_GATHER_FINEST_LEVEL));

// One cone from a point near a surface with that normal. Samples beyond `reach` are not taken. Lengths in voxels.
ConeResult traceCone(vec3 start, vec3 normal, vec3 direction, float reach) {
    float voxel = 1.0 / float(frame.grid.x);
    Ray ray = rayAlong(direction);
    ConeResult result = ConeResult(vec3(0.0), 1.0);
    // Faces are one-sided along the axes only: the ray also meets those of its own surface that look against it, the
    // more the further the surface is from an axis. It starts behind them.
    vec3 own = max(-direction * normal, 0.0);
    float distance = VCT_GATHER_FIRST_SAMPLE + VCT_GATHER_OWN_SURFACE * (own.x + own.y + own.z);
    // The volume's diagonal in the shortest steps: a bound for the driver, never reached.
    for (int i = 0; i < 512 && distance < reach; ++i) {
        vec3 p = (start + direction * distance) * voxel;
        vec3 fromCentre = abs(p - 0.5);
        if (max(fromCentre.x, max(fromCentre.y, fromCentre.z)) > 0.5) break;
        TRIP(VCT_CONE_TRIPS);
        float diameter = max(finestFootprint, 2.0 * distance * VCT_GATHER_TANGENT);
        // Wider than its height above the tangent plane, a sample would contain the surface that it starts from.
        float height = VCT_GATHER_START + distance * dot(direction, normal);
        // Whole levels: a wall's coverage sums to 1 over samples that are a texel apart, only if the texel's size is
        // the footprint.
        float level = floor(log2(max(finestFootprint, min(diameter, VCT_GATHER_HEIGHT * height))));
        float footprint = exp2(level);
        // Steps longer than the footprint would skip matter.
        float stride = VCT_GATHER_STEP * min(diameter, VCT_GATHER_SKIP * footprint);
        mediump vec4 value = HALF(sampleFaces(p, ray, level) * (VCT_GATHER_EXTINCTION * stride / footprint));
        // Added, and cut off at what is left: multiplied transmittances let too much through.
        mediump float share = HALF(min(1.0, result.transmittance / max(value.a, 1e-4)));
        result.radiance = HALF(result.radiance + value.rgb * share);
        result.transmittance = HALF(result.transmittance - value.a * share);
        if (result.transmittance < VCT_GATHER_THRESHOLD) break;
        distance += stride;
    }
    result.radiance = HALF(result.radiance * frame.faces.y);
    return result;
}
