// Thin walls across the bricks of face irradiance. Where a thin wall meets a floor, the same voxels hold the
// floor on both sides of the wall, and the filter of a look-up would carry light from one side to the other.
// For each brick there is a word with the wall, if any, across each of the two axes of the brick's faces; a
// look-up beside a wall reads the nearest texel on its own side only (directional/irradiance.glsl).
//
// The word's fields, from the lowest: 8 bits each for the walls' positions along the first and the second
// axis, from the brick's first texel in units of 1 / wallUnits texels; a bit for each of the brick's six
// layers of texels that the first wall crosses, then six bits for the second wall; a bit per wall, set if the
// texel that holds it belongs to neither side. The outer layers are the borders of the brick and have the
// bits of the voxels beside them.
const float wallUnits = 42.0;

// Merges the walls of two words; the order does not matter. Of two walls across the same axis, the one at the
// larger position stays.
uint mergeWalls(uint a, uint b) {
    return ((a | b) & 0x3FFF0000u) | max(a & 0xFFu, b & 0xFFu) | max(a & 0xFF00u, b & 0xFF00u);
}

// The bits of the layers that show a wall in one of the block's four layers of voxels.
uint layerBits(uint layer) {
    return (1u << (layer + 1u)) | (layer == 0u ? 1u : layer == 3u ? 1u << 5 : 0u);
}

struct WallsBeside {
    vec2 position;  // in texels from the brick's first one
    bvec2 crosses;  // the wall crosses the layer
};

// The word's walls, and whether they cross the layers of the point `across`.
WallsBeside wallsBeside(uint word, vec2 across) {
    uvec2 layer = uvec2(across.yx);
    return WallsBeside(vec2(word & 0xFFu, word >> 8 & 0xFFu) * (1.0 / wallUnits),
                       bvec2((word >> (16u + layer.x) & 1u) != 0u, (word >> (22u + layer.y) & 1u) != 0u));
}

// Moves a position in a brick away from the walls of the word, to where the filter reads texels of the
// position's own side only. `along`: unit vector of the axis that the brick's faces look along.
vec3 besideWalls(uint word, vec3 inBrick, vec3 along) {
    vec2 across = vec2(dot(inBrick, along.zxy), dot(inBrick, along.yzx));
    WallsBeside walls = wallsBeside(word, across);
    // At the middle of its texel, a wall keeps both sides from reading it.
    bvec2 keepsOff = bvec2((word & 1u << 28u) != 0u, (word & 1u << 29u) != 0u);
    vec2 at = mix(walls.position, floor(walls.position) + 0.5, keepsOff);
    vec4 moved = max(vec4(-across, across), floor(vec4(-at, at) + 0.5) + 0.5);
    vec2 beside = mix(-moved.xy, moved.zw, greaterThan(across, walls.position));
    beside = mix(across, beside, walls.crosses);
    return inBrick * along + beside.x * along.zxy + beside.y * along.yzx;
}
