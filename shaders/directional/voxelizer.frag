// Second of two passes over the triangles: each fragment adds its coverage, albedo, plane and radiance to the faces of its
// voxel that it looks towards. Sums of integers: the order of the fragments changes nothing. VCT_RELIGHT (true or
// false): the radiance alone, as the rest is there.
#include "shared/counters.glsl"
#include "shared/material.glsl"
#include "directional/face_list.glsl"
#include "shared/octahedral.glsl"
#include "shared/shadow.glsl"
#ifdef VCT_DIRTY_BLOCKS
#include "directional/dirty_blocks.glsl"
#else
bool isDirty(ivec3 voxel) {
    return true;
}
#endif

in vec3 fragmentPosition;
in vec3 fragmentNormal;

layout(binding = VCT_TEX_VOXELS) uniform usampler3D index;

#ifdef VCT_PUNCTUAL_LIGHTS
#include "shared/punctual_lights.glsl"
#else
vec3 punctualIrradiance(vec3 position, vec3 normal) {
    return vec3(0.0);
}
#endif

// `normal`: of this side of the surface.
vec3 directRadiance(vec3 albedo, vec3 normal) {
    float cosTheta = max(dot(normal, frame.towardsLight.xyz), 0.0);
    float light = cosTheta > 0.0 ? shadowMapLightOn(fragmentPosition, normal) : 0.0;
    return albedo * cosTheta * light * frame.lightColor.rgb + albedo * punctualIrradiance(fragmentPosition, normal);
}

const bool relight = VCT_RELIGHT;

// One side of the surface. `weights`: of the faces towards +x, +y, +z where positive, -x, -y, -z where negative. `normal`:
// of this side; `fromMiddle`: to the surface, in voxels.
void addSide(uint slot, vec3 weights, vec3 normal, vec3 fromMiddle, vec3 albedo, vec3 radiance) {
    if (relight && radiance == vec3(0.0)) return;
    uint marked = 0u;
    for (int axis = 0; axis < 3; ++axis)
        if (fixedCoverage(abs(weights[axis])) > 0u) marked |= 1u << uint(2 * axis + (weights[axis] > 0.0 ? 0 : 1));
    if (!relight && marked != 0u) {
        markFaces(slot, marked);
        if (materialEmits && draw.surface.w > 0.0) markGlowing(slot, marked);
    }
    // Most surfaces face along one axis.
    for (uint left = marked; left != 0u; left &= left - 1u) {
        COUNT(VCT_COUNTER_FACE_VOXELIZER_AXIS);
        int face = findLSB(left);
        float weight = abs(weights[face >> 1]);
        if (!relight) addSurface(slot, face, weight, albedo, normal, dot(normal, fromMiddle));
        addRadiance(slot, face, weight, radiance);
    }
}

void main() {
    COUNT(VCT_COUNTER_FACE_VOXELIZER);
    vec4 baseColor = materialBaseColor();
    if (materialIsUnlit) baseColor.rgb = vec3(0.0);
    // Before any discard: derivatives need the whole quad. This is the face's normal over its component along the
    // projection, times a pixel's area in voxels: what the surface covers of each of the voxel's cross-sections.
    vec3 positionVoxels = fragmentPosition * float(frame.gridSide);
    vec3 coverage = clamp(cross(dFdx(positionVoxels), dFdy(positionVoxels)), -1.0, 1.0);
    if (!gl_FrontFacing) coverage = -coverage;
    if (materialIsHole(baseColor.a)) discard;

    ivec3 voxel = clamp(ivec3(floor(positionVoxels)), ivec3(0), ivec3(frame.gridSide - 1));
    if (!isDirty(voxel)) discard;
    uint slot = texelFetch(index, voxel, 0).r - 1u;
    if (slot >= voxelPlaces()) return;  // no room in the list: reported by the program

    vec3 normal = safeNormalize(fragmentNormal);
    vec3 emissive = materialEmissive() * draw.surface.w;
    vec3 fromMiddle = positionVoxels - vec3(voxel) - 0.5;
    addSide(slot, coverage, normal, fromMiddle, baseColor.rgb, directRadiance(baseColor.rgb, normal) + emissive);
    if (materialIsDoubleSided)
        addSide(slot, -coverage, -normal, fromMiddle, baseColor.rgb, directRadiance(baseColor.rgb, -normal) + emissive);
}
