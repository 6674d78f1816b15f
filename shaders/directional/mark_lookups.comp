// Marks the blocks whose faces pixels look up with the number of the light step. In each step one pixel of
// each tile of 8 x 8 pixels is considered, a different one every time.
#include "shared/counters.glsl"
#include "shared/surface.glsl"
#include "directional/voxels.glsl"
#include "directional/cascades.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32ui, binding = VCT_IMAGE_LAST_LOOKUPS) writeonly uniform highp uimage3D lastLookups;

// Marks the blocks of a cascade around a surface.
void markBlocks(vec3 positionVolume, vec3 normal, int cascade) {
    vec3 position = voxelsFromVolume(positionVolume, cascade);
    int blocks = frame.gridSide >> VCT_BRICK_LEVEL;
    // If a surface lies on the border of two blocks, rounding decides which block has its faces. Both are
    // marked.
    for (int i = 0; i < 6; ++i) {
        int axis = i % 3;
        if (abs(normal[axis]) < 0.14) continue;
        ivec3 block = ivec3(floor(position + (i < 3 ? 0.5 : -0.5) * normal)) >> VCT_BRICK_LEVEL;
        ivec3 texel = faceTexel(clampToCascade(block, ivec3(0, 0, cascade * blocks), blocks), axis,
                                normal[axis] > 0.0 ? 0 : 1, blocks);
        imageStore(lastLookups, texel, uvec4(lightStep.frame + 1u));
    }
}

void main() {
    COUNT(VCT_COUNTER_MARK_LOOKUPS);
    uint step = lightStep.frame;
    ivec2 pixel = 8 * ivec2(gl_GlobalInvocationID.xy) + ivec2(step * 5u & 7u, step * 3u + step / 8u & 7u);
    if (any(greaterThanEqual(pixel, textureSize(depthTarget, 0)))) return;
    float depth = surfaceDepth(pixel);
    if (depth == 1.0) return;
    vec3 position = surfacePosition(vec2(pixel) + 0.5, depth);
    LookUpCascade from = lookUpCascade(position);
    markBlocks(position, geometricNormal(pixel), from.cascade);
    if (from.share < 1.0) markBlocks(position, geometricNormal(pixel), from.cascade + 1);
}
