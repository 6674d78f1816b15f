// Look-up of face irradiance for a surface. Irradiance is stored in bricks. A brick belongs to one face of a
// block of 4^3 voxels. It holds the block's 4^3 base-level faces of that direction, and a border of one texel
// so that the texture unit can filter across blocks. Of the layers of texels along the axis of its faces, it
// stores those between the first and the last one that has a face: on most walls and floors that is one. A
// texel holds irradiance, relative to E and premultiplied by coverage, in rgb, and coverage in alpha. It has
// half floats, because filtering of 8 bits would show steps that move with the camera.
#include "shared/frame.glsl"
#include "directional/voxels.glsl"
#include "directional/cascades.glsl"
#include "directional/walls.glsl"

layout(binding = VCT_TEX_BRICKS) uniform mediump sampler3D bricks;
layout(binding = VCT_TEX_BRICK_PLACES) uniform highp usampler3D brickPlaces;  // packBrick(); 0: no brick
layout(binding = VCT_TEX_WALLS) uniform highp usampler3D walls;               // thin walls across bricks

// The square of a normal's component along an axis whose faces the surface hardly looks towards. Few of these
// are its own, and beside a wall they would be the wall's, of either side.
const float hardlyTowards = 0.15;

// The brick of a block's face.
uint brickAt(ivec3 block, int axis, int side) {
    return texelFetch(brickPlaces, faceTexel(block, axis, side, frame.gridSide >> VCT_BRICK_LEVEL), 0).r;
}

// The offset from a brick's first texel to a position in the block, or up to half a voxel beside it. In
// voxels.
vec3 positionInBrick(vec3 position, ivec3 block) {
    return position - vec3(block * VCT_BRICK_SIDE - 1);
}

// The filtered content of a brick at an offset from the first of its 6^3 texels, along the two axes that the
// faces span and along their own; 0 if there is no brick.
mediump vec4 irradianceInBrick(uint brick, vec3 across) {
    // The fields of packBrick() are not shifted: a float holds them exactly, and one product shifts and
    // scales.
    const vec3 texelsOfUnit = vec3(VCT_BRICK_TEXELS, VCT_BRICK_TEXELS, 1) / vec3(1 << 17, 1 << 10, 1);
    vec2 layers = vec2(brick & 0x7000000u, brick & 0x38000000u) * (1.0 / vec2(1 << 24, 1 << 27));
    float along = across.z - layers.x, stored = clamp(along, 0.5, layers.y - 0.5);
    vec3 texel =
        vec3(across.xy, stored) + vec3(brick & 0xFE0000u, brick & 0x1FC00u, brick & 0x3FFu) * texelsOfUnit;
    mediump vec4 received = textureLod(bricks, texel * (1.0 / vec3(textureSize(bricks, 0))), 0.0);
    // Beside the layers that are stored, the filter would read texels without light.
    mediump float share = (brick & VCT_BRICK_IS_FLAT) != 0u ? 1.0 : max(1.0 - abs(along - stored), 0.0);
    // A selection is cheaper than a branch, because nearly all bricks exist.
    return brick != 0u ? share * received : vec4(0.0);
}

// The filtered content of the brick of a block's face at a position of a surface with this normal. If
// `hasSides`, a position beside a thin wall takes its own side, if need be of the next block. `hasWalls`
// becomes true if there is a wall.
mediump vec4 irradianceOfBlock(ivec3 block, int axis, int side, vec3 inBrick, vec3 normal, bool hasSides,
                               inout bool hasWalls) {
    int blocks = frame.gridSide >> VCT_BRICK_LEVEL;
    ivec3 texel = faceTexel(block, axis, side, blocks);
    uint brick = texelFetch(brickPlaces, texel, 0).r;
    vec3 position = vec3(acrossFaces(inBrick, axis), inBrick[axis]), moved = position;
    vec3 normalAcross = vec3(acrossFaces(normal, axis), normal[axis]);
    bool isBesideWall = hasSides && (brick & VCT_BRICK_HAS_WALLS) != 0u;
    hasWalls = hasWalls || isBesideWall;
    for (int i = isBesideWall ? 0 : 2; i < 2; ++i) {
        uint word = texelFetch(walls, wallTexel(texel, i, blocks * cascades), 0).r;
        moved = besideWall(word, position, moved, normalAcross);
        // The texels of the position's own side may begin in the next block. A brick is filtered between the
        // middles of its outer texels, at 0.5 and 5.5.
        float aside = step(5.51, moved.x) - step(moved.x, 0.49);
        ivec3 next =
            clampToCascade(block + ivec3(fromAcross(i == 0 ? vec2(aside, 0.0) : vec2(0.0, aside), 0.0, axis)),
                           block, blocks);
        moved.x = clamp(next == block ? moved.x : moved.x - float(VCT_BRICK_SIDE) * aside, 0.501, 5.499);
        block = next;
        brick = brickAt(block, axis, side);
        moved = moved.yxz;
        position = position.yxz;
        normalAcross = normalAcross.yxz;
    }
    return irradianceInBrick(brick, moved);
}

// The vector from the middle of a unit cube to corner `i`, selected by the last three bits.
vec3 cornerOffset(uint i) {
    return vec3(i & 1u, i >> 1 & 1u, i >> 2 & 1u) - 0.5;
}

// Irradiance of a surface at a position (volume space) from one cascade, relative to E. It is the mean over
// the faces on the normal's side of each axis, weighted by the square of the normal, as in an ambient cube
// (McTaggart 2004, "Half-Life 2 / Valve Source Shading").
//
// If the voxels around the position have no such faces, up to fifteen other places are tried. Rounding may
// have moved a surface on the border of two blocks into the other block: the first eight tries use the bricks
// of the blocks at most half a voxel away. It may also have moved a surface that ends at a wall, as in a
// crease, to the wall's other side, so these tries read both sides. A surface so thin that the voxels missed
// it takes the light in the middle of its block, of faces on the normal's side or else on the other, and then
// of blocks beside it. All tries share the fetch in the loop, because a second fetch would cost registers in
// every pixel.
mediump vec3 irradianceInCascade(vec3 positionVolume, vec3 normal, int cascade) {
    // An axis with a smaller weight is skipped, because the others give nearly the same result.
    const float minWeight = 0.02;
    // With less coverage the result is unknown.
    const mediump float minCoverage = 0.03;
    const uint borderTries = 8u, tries = borderTries + 7u;

    vec3 position = voxelsFromVolume(positionVolume, cascade);
    ivec3 block = ivec3(position) >> VCT_BRICK_LEVEL;
    vec3 inBrick = positionInBrick(position, block);
    int axes = int(dot(step(minWeight, normal * normal), vec3(1.0, 2.0, 4.0)));  // one bit per axis, never 0
    float more = 0.0;  // added to the size of the normal's component along an axis
    mediump vec4 sum = vec4(0.0), surplus = vec4(0.0);  // surplus: not counted beside walls
    bool hasWalls = false;
    for (uint i = 0u;; ++i) {
        do {
            int axis = min(axes >> 1, 2);
            axes -= 1 << axis;
            float along = dot(normal, vec3(equal(ivec3(axis), ivec3(0, 1, 2))));
            along += along < 0.0 ? -more : more;
            mediump float weight = along * along;
            mediump vec4 found = irradianceOfBlock(block, axis, along > 0.0 ? 0 : 1, inBrick, normal,
                                                   i == 0u || i > borderTries, hasWalls);
            sum += weight * found;
            surplus += min(weight, hardlyTowards) * found;
        } while (axes > 0);
        if (i == 0u && hasWalls) sum -= surplus;
        if (i == tries || sum.a >= minCoverage) break;

        bool onBorder = i < borderTries;
        vec3 size = abs(normal);
        axes = !onBorder ? 7 : size.x >= max(size.y, size.z) ? 1 : size.y >= size.z ? 2 : 4;
        float aside = onBorder ? 1.0 : i < borderTries + 2u ? 0.0 : float(VCT_BRICK_SIDE);
        int blocks = frame.gridSide >> VCT_BRICK_LEVEL;
        block = clampToCascade(ivec3(position + aside * cornerOffset(i)) >> VCT_BRICK_LEVEL,
                               ivec3(0, 0, cascade * blocks), blocks);
        inBrick = onBorder ? positionInBrick(position, block) : vec3(3.0);
        // In the middle of a block, faces along all axes count, on the normal's side or on the other.
        if (!onBorder) more = i == borderTries + 1u ? -1.5 : 0.5;
    }
    return sum.rgb / max(sum.a, 1e-4);
}

// Irradiance of a surface at a position (volume space), relative to E. A position outside of the volume takes
// the light at its border, because the textures go on there with the faces of another axis or cascade.
mediump vec3 sampleIrradiance(vec3 positionVolume, vec3 normal) {
    positionVolume = clamp(positionVolume, 0.0, 0.9999);
    LookUpCascade from = lookUpCascade(positionVolume);
    mediump vec3 found = irradianceInCascade(positionVolume, normal, from.cascade);
    if (cascades == 1 || from.share == 1.0) return found;
    return mix(irradianceInCascade(positionVolume, normal, from.cascade + 1), found, from.share);
}

// Ambient visibility (1 - ambient occlusion), if the faces have gathered it in place of light.
mediump float ambientVisibilityAt(vec3 position, vec3 normal) {
    return sampleIrradiance(position, normal).r;
}
