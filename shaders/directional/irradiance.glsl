// The light that the voxels' faces received, where a surface looks it up. It lies in bricks: of each face that is not empty
// of the level whose voxels are blocks of 4^3, the 4^3 faces of the base level that look the same way, and one more on each
// side, so that the texture unit can filter between them. A texel holds the face's coverage in alpha, and in rgb the mean
// over the hemisphere, weighted by the cosine, relative to E/pi, times alpha: in halves, as in 8 bits the filter itself would
// make stairs of it, which swim as the camera moves.
#include "shared/frame.glsl"
#include "directional/voxels.glsl"
#include "shared/counters.glsl"

layout(binding = VCT_TEX_IRRADIANCE) uniform mediump sampler3D irradiance;
layout(binding = VCT_TEX_BRICKS) uniform highp usampler3D bricks;  // packBrick(), 0 where there is none

// Of a block in the volume.
uint brickAt(ivec3 block, int axis, int side) {
    return texelFetch(bricks, faceTexel(block, axis, side, frame.gridSide >> VCT_BRICK_LEVEL), 0).r;
}

// From a brick's first texel to a position in a block (both in voxels), which may lie half a voxel beside it.
vec3 inBrickOf(vec3 position, ivec3 block) {
    return position - vec3(block * VCT_BRICK_SIDE - 1);
}

// What a brick holds at a place in it, between its texels; nothing if it is none.
mediump vec4 irradianceInBrick(uint brick, vec3 inBrick) {
    // packBrick()'s numbers where they stand: a float holds them as exactly there, and one product shifts and scales them.
    const vec3 texelsOfUnit = float(VCT_BRICK_TEXELS) / vec3(1 << 20, 1 << 10, 1);
    vec3 texel = inBrick + vec3(brick & 0x3FF00000u, brick & 0xFFC00u, brick & 0x3FFu) * texelsOfUnit;
    mediump vec4 received = textureLod(irradiance, texel * (1.0 / vec3(textureSize(irradiance, 0))), 0.0);
    // Not a branch: nearly all are one.
    return brick != 0u ? received : vec4(0.0);
}

// The irradiance around a position (in voxels) of the faces towards one side of an axis, premultiplied by their coverage, and
// that coverage. `block`: the position's, or one that is no more than half a voxel away.
mediump vec4 irradianceOfFaces(vec3 position, ivec3 block, int axis, int side) {
    return irradianceInBrick(brickAt(block, axis, side), inBrickOf(position, block));
}

// From the middle of a cube to one of its corners, by the last three bits.
vec3 cornerOffset(uint i) {
    return vec3(i & 1u, i >> 1 & 1u, i >> 2 & 1u) - 0.5;
}

// The irradiance of a surface at a position (volume space), relative to E/pi: of the faces on the normal's side of each axis,
// by the square of the normal, as from an ambient cube (McTaggart 2004, "Half-Life 2 / Valve Source Shading").
//
// Where the voxel of a surface has no face of it, other places are tried. On the border of two blocks it may have been
// rounded into the other, whose brick reaches as far: eight tries at that. And a surface so thin that voxels missed it takes
// the mean of what its block's faces received that look the same way, or else the other way: six faces with eight fetches
// each, between eight texels; and if there are none, those of the blocks around it. All of them go through the one fetch
// below, as a second would hold its registers in every pixel for the few that need it.
mediump vec3 sampleIrradiance(vec3 positionVolume, vec3 normal) {
    // What looks this little along an axis has received nearly the same along the others.
    const float leastWeight = 0.02;
    // Of less coverage than this nothing is known.
    const mediump float leastCoverage = 0.03;
    const uint borderTries = 8u, tries = borderTries + 9u * 48u;

    vec3 position = positionVolume * float(frame.gridSide);
    ivec3 block = ivec3(position) >> VCT_BRICK_LEVEL;
    vec3 inBrick = inBrickOf(position, block);
    int axes = int(dot(step(leastWeight, normal * normal), vec3(1.0, 2.0, 4.0)));  // a bit each; never none
    float instead = 0.0;  // of the normal along the axis, but where 0
    mediump vec4 sum = vec4(0.0);
    for (uint i = 0u;; ++i) {
        do {
            COUNT(VCT_COUNTER_IRRADIANCE_AXIS);
            int axis = min(axes >> 1, 2);
            axes -= 1 << axis;
            float along = instead != 0.0 ? instead : dot(normal, vec3(equal(ivec3(axis), ivec3(0, 1, 2))));
            mediump float weight = along * along;
            sum += weight * irradianceInBrick(brickAt(block, axis, along > 0.0 ? 0 : 1), inBrick);
        } while (axes > 0);
        // A face of a block has all its eight fetches or none.
        bool whole = i <= borderTries || (i & 7u) == 0u;
        if (i == tries || whole && sum.a >= leastCoverage) break;
        COUNT(VCT_COUNTER_IRRADIANCE_NEARBY);

        bool onBorder = i < borderTries;
        uint face = (i >> 3) % 6u, around = (i - borderTries) / 48u;
        vec3 size = abs(normal);
        int axis = onBorder ? size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2 : int(face >> 1);
        float side = (face & 1u) == 0u ? 1.0 : -1.0, cosine = side * normal[axis];
        if (!onBorder) instead = side * (cosine > 0.1 ? cosine : 0.01);
        float aside = onBorder ? 1.0 : around == 0u ? 0.0 : 4.0;
        ivec3 last = ivec3((frame.gridSide >> VCT_BRICK_LEVEL) - 1);
        block = clamp(ivec3(position + aside * cornerOffset(onBorder ? i : around)) >> VCT_BRICK_LEVEL, ivec3(0), last);
        inBrick = onBorder ? inBrickOf(position, block) : 2.0 * cornerOffset(i) + 3.0;
        axes = 1 << axis;
    }
    return sum.rgb / max(sum.a, 1e-4);
}

// 1 - ambient occlusion, where that is what the faces have gathered.
mediump float ambientVisibilityAt(vec3 position, vec3 normal) {
    return sampleIrradiance(position, normal).r;
}
