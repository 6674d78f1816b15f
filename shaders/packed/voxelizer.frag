// One voxel per fragment: material and direct light, packed, kept by imageAtomicMax (thesis 4.4). Which
// fragment comes first changes nothing but the order of the active-voxel list.
#include "shared/material.glsl"
#include "shared/commands.glsl"
#include "shared/octahedral.glsl"
#include "shared/shadow.glsl"
#include "shared/counters.glsl"

in vec3 fragmentPosition;
in vec3 fragmentNormal;
#ifdef VCT_BASE_COLOR_TEXTURE
in vec2 fragmentUv;
#else
const vec2 fragmentUv = vec2(0.0);
#endif
#ifdef VCT_EMISSIVE_TEXTURE
in vec2 fragmentEmissiveUv;
#else
const vec2 fragmentEmissiveUv = vec2(0.0);
#endif

layout(r32ui, binding = VCT_IMAGE_VOXELS) uniform uimage3D voxels;

void main() {
    COUNT(VCT_COUNTER_VOXELIZER);
    vec4 baseColor = materialBaseColor(fragmentUv);
    if (materialIsHole(baseColor.a)) discard;
    ivec3 voxel = clamp(ivec3(floor(fragmentPosition * float(frame.grid.x))), ivec3(0), ivec3(frame.grid.x - 1));

    float facing = dot(safeNormalize(fragmentNormal), frame.towardsLight.xyz);
    // A single-sided surface is black from behind; a sheet is lit on the side that the light sees.
#ifdef VCT_DOUBLE_SIDED
    float cosTheta = abs(facing);
#else
    float cosTheta = max(facing, 0.0);
#endif
    bool lit = shadowMapLight(fragmentPosition, cosTheta) >= 0.5;
    vec3 radiance = cosTheta * baseColor.rgb * frame.lightColor.rgb;  // thesis eq. 4.4
#ifdef VCT_EMISSIVE
    vec3 emissive = materialEmissive(fragmentEmissiveUv);
    if (emissive != vec3(0.0)) {
        radiance = emissive + (lit ? radiance : vec3(0.0));
        lit = true;
    }
#endif

    uvec3 color = uvec3(clamp(radiance, 0.0, 1.0) * float(VCT_BASE_COUNT * VCT_COLOR_STEPS) + 0.5);
    uint word = packVoxel(lit ? VCT_BASE_COUNT : 0u, VCT_BASE_COUNT, color);
    if (imageAtomicMax(voxels, voxel, word) == 0u) appendVoxel(0u, uvec3(voxel));
}
