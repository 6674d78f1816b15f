// Thin walls across the bricks of face irradiance. Where a thin wall meets a floor, the same voxels hold the
// floor on both sides of the wall, and the filter of a look-up would carry light from one side to the other.
// For each brick there is a word with the wall, if any, across each of the two axes of the brick's faces; a
// look-up beside a wall reads the nearest texel on its own side only (directional/irradiance.glsl).
//
// The word's bytes, from the lowest: the walls' positions along the first and the second axis, from the
// brick's first texel in units of 1 / wallUnits texels; a bit for each of the block's four layers of
// voxels that the first wall crosses, then four bits for the second wall; a bit per wall, set if the texel
// that holds it belongs to neither side.
const float wallUnits = 42.0;

// Merges the walls of two words; the order does not matter. Of two walls across the same axis, the one at the
// larger position stays.
uint mergeWalls(uint a, uint b) {
    return ((a | b) & 0x3FF0000u) | max(a & 0xFFu, b & 0xFFu) | max(a & 0xFF00u, b & 0xFF00u);
}

// The components along the axes that a brick's faces span, cyclically behind the axis that they look along.
vec2 acrossFaces(vec3 v, int axis) {
    return axis == 0 ? v.yz : axis == 1 ? v.zx : v.xy;
}
vec3 withAcross(vec3 v, vec2 across, int axis) {
    return axis == 0 ? vec3(v.x, across) : axis == 1 ? vec3(across.y, v.y, across.x) : vec3(across, v.z);
}

// The positions of a word's walls that cross the layers of the point `across`, in texels from the brick's
// first one. A position far below the brick stands for no wall.
const float noWall = -1000.0;
vec2 wallsBeside(uint word, vec2 across) {
    uvec2 layer = uvec2(clamp(across.yx - 1.0, 0.0, 3.0)) + uvec2(16, 20);
    vec2 wall = vec2(word & 0xFFu, word >> 8 & 0xFFu) / wallUnits;
    return vec2((word >> layer.x & 1u) != 0u ? wall.x : noWall,
                (word >> layer.y & 1u) != 0u ? wall.y : noWall);
}

// Moves a position in a brick away from the walls of the word, to where the filter reads texels of the
// position's own side only.
vec3 besideWalls(uint word, vec3 inBrick, int axis) {
    vec2 across = acrossFaces(inBrick, axis);
    vec2 wall = wallsBeside(word, across);
    // At the middle of its texel, a wall keeps both sides from reading it.
    vec2 keepsOff = vec2(word >> 24 & 1u, word >> 25 & 1u), at = mix(wall, floor(wall) + 0.5, keepsOff);
    vec2 below = min(across, ceil(at - 0.5) - 0.5), above = max(across, floor(at + 0.5) + 0.5);
    return withAcross(inBrick, mix(below, above, greaterThan(across, wall)), axis);
}
