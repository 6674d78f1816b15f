// The irradiance of each block of 4^3 voxels, per face direction: a mean over the faces and over a few steps,
// premultiplied by the coverage of the faces that gathered, which is in alpha. Resets the sums of the step.
#include "shared/commands.glsl"
#include "shared/counters.glsl"
#include "directional/irradiance.glsl"
#include "directional/gather_turns.glsl"
#include "directional/last_lookups.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(binding = VCT_TEX_BLOCK_LIGHT) uniform mediump sampler3D blockLight;
layout(rgba16f, binding = VCT_IMAGE_BLOCK_LIGHT) writeonly uniform mediump image3D blockLightTexels;

// The weight of one step in the mean. It can be large, because a block's faces have many cones together. If
// faces take turns, it is smaller, which divides the error between more noise and a longer lag.
float shareOfStep(ivec3 block) {
    return 0.3 * sqrt(turnRate(isLookedUp(block)));
}

void main() {
    COUNT(VCT_COUNTER_LIGHT_BLOCKS);
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel, imageSize(blockLightTexels)))) return;
    vec4 light = vec4(0.0);
    uint brick = texelFetch(bricks, texel, 0).r;
    if (brick != 0u) {
        uint at = blockSums(brick);
        vec4 sum = vec4(uvec4(faceIrradianceData[at], faceIrradianceData[at + 1u],
                              faceIrradianceData[at + 2u], faceIrradianceData[at + 3u])) /
                   VCT_BLOCK_UNITS;
        for (uint c = 0u; c < 4u; ++c)
            faceIrradianceData[at + c] = 0u;
        // The texture is uninitialized before the first step.
        vec4 before = lightStep.maxInheritedHistory > 0.0 ? texelFetch(blockLight, texel, 0) : vec4(0.0);
        light = vec4(sum.rgb * lightRange, sum.a) / float(VCT_BRICK_SIDE * VCT_BRICK_SIDE);
        if (before.a > 0.0) light = sum.a > 0.0 ? mix(before, light, shareOfStep(texel)) : before;
    }
    imageStore(blockLightTexels, texel, light);
}
