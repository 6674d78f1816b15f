// Thin walls across the bricks of face irradiance. Where a thin wall meets a floor, the same voxels hold the
// floor on both sides of the wall, and the filter of a look-up would carry light from one side to the other.
// So a look-up beside a wall reads texels of its own side only.
//
// A brick has two words, each for the wall, if any, that crosses its faces mostly across the first or the
// second of the axes that the faces span. Walls are planes. The word's fields, from the highest: 9 bits for
// the wall's position along the axis that it crosses, at the middle of the brick; 4 bits each for how far
// from the plane, along that axis, the texels above and those below begin that are of one side alone; 5 bits
// for the change of the position along the other of the two axes, and 6 along the axis that the faces look
// along; a bit for each of the block's four layers of voxels along the other axis that the wall crosses.
// Lengths are in texels, which are as large as voxels. A slope of 0 is stored exactly: along a wall that
// follows an axis, an error would begin the texels of one side in steps.
const vec2 wallPositions = vec2(-3.5, 9.5), wallOtherSlopes = vec2(-1.05, 1.12),
           wallFaceSlopes = vec2(-2.1, 2.31), wallDistances = vec2(-1.75, 2.0);

struct ThinWall {
    float position, above, below;
    vec2 slope;  // along the other axis, and along the faces' axis
};

uint packField(float value, vec2 range, int bits) {
    float steps = float((1 << bits) - 1);
    return uint(clamp((value - range.x) / (range.y - range.x), 0.0, 1.0) * steps + 0.5);
}
uint packWall(ThinWall wall, uint layer) {
    return packField(wall.position, wallPositions, 9) << 23 | packField(wall.above, wallDistances, 4) << 19 |
           packField(wall.below, wallDistances, 4) << 15 | packField(wall.slope.x, wallOtherSlopes, 5) << 10 |
           packField(wall.slope.y, wallFaceSlopes, 6) << 4 | 1u << layer;
}
float unpackField(uint word, int low, int bits, vec2 range) {
    uint steps = (1u << bits) - 1u;
    return float(word >> low & steps) * ((range.y - range.x) / float(steps)) + range.x;
}

// Merges two words of a brick; the order does not matter. Of two walls, the one at the larger position stays.
uint mergeWalls(uint a, uint b) {
    return max(a & ~15u, b & ~15u) | (a | b) & 15u;
}

// The texel of a brick's word. `depth`: of the texture of bricks, behind which the second words follow.
ivec3 wallTexel(ivec3 brickTexel, int word, int depth) {
    return brickTexel + ivec3(0, 0, word * depth);
}

// Moves a position in a brick to where the filter reads texels of the position's own side of a wall. `moved`:
// the position after another wall has moved it. Its components, and those of `position` and the normal, are
// along the axis that the wall mostly crosses, along the other of the two axes that the faces span, both in
// texels from the brick's first one, and along the axis that the faces look along.
vec3 besideWall(uint word, vec3 position, vec3 moved, vec3 normal) {
    // Walls are known to a tenth of a texel. On a wall itself the normal tells the side.
    const float tolerance = 0.3;
    if ((word >> (uint(position.y) - 1u & 3u) & 1u) == 0u) return moved;
    vec2 slope = vec2(unpackField(word, 10, 5, wallOtherSlopes), unpackField(word, 4, 6, wallFaceSlopes));
    float wall = unpackField(word, 23, 9, wallPositions) + dot(slope, position.yz - 3.0);
    bool isAbove = position.x + tolerance * (normal.x - dot(slope, normal.yz)) > wall;
    float way = isAbove ? 1.0 : -1.0, distance = unpackField(word, isAbove ? 19 : 15, 4, wallDistances);
    // The filter reads two layers of texels along each of the other axes. The wall is nearer to one of them.
    vec2 nearer = way * sign(slope), layer = nearer * ceil(nearer * (position.yz - 0.5)) + 0.5;
    float nearest = way * (wall + dot(slope, layer - position.yz)) + distance - 0.5;
    // Up to the next pair of layers the position changes gradually, so that a slanted wall leaves no steps.
    float towardsNext = 1.0 - nearer.x * (layer.x - position.y);
    nearest = mix(ceil(nearest), ceil(nearest + abs(slope.x)), towardsNext) + 0.5;
    // At the middle of a texel, rounding must not give the texel before it a weight.
    const float rounding = 0.001;
    float aside = way * max(way * position.x, nearest) + rounding - position.x;
    // It stays on the surface.
    float steepness = clamp(-normal.x / (abs(normal.z) > 0.1 ? normal.z : 0.1), -2.0, 2.0);
    return moved + aside * vec3(1.0, 0.0, steepness);
}
