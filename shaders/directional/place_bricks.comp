// Assigns a brick of face irradiance to each occupied face of the level whose voxels are blocks. The brick
// stores the layers between the first and the last one with faces of that direction, of the block or in its
// border. Each cascade has room of its own in the texture of bricks, so that the bricks of a cascade that
// stays keep their places while others move. Clears the brick, because fill_bricks.comp writes the texels of
// faces only. The brick's walls are the static ones, until mark_walls.comp adds those of dynamic objects.
#include "directional/face_lists.glsl"
#include "directional/cascades.glsl"
#include "directional/voxels.glsl"
#include "directional/walls.glsl"
#include "directional/light_step.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba16f, binding = VCT_IMAGE_BRICKS) writeonly uniform mediump image3D brickTexels;
layout(r32ui, binding = VCT_IMAGE_BRICK_PLACES) writeonly uniform highp uimage3D brickPlaces;
layout(r32ui, binding = VCT_IMAGE_WALLS) writeonly uniform highp uimage3D walls;
#if VCT_CASCADES == 1
layout(binding = VCT_TEX_WALLS) uniform highp usampler3D staticWalls;
#endif
layout(location = VCT_UNIFORM_PLACED) uniform uint placed;  // a bit per cascade whose bricks are placed

// A bit for each layer of a block along an axis that has faces. `voxels`: the 64 bits of the block's voxels.
uint layersOf(uvec2 voxels, int axis) {
    if (axis == 2) {
        uvec2 pairs = uvec2(notEqual(voxels & 0xFFFFu, uvec2(0u))) | uvec2(notEqual(voxels >> 16u, uvec2(0u)))
                                                                         << 1u;
        return pairs.x | pairs.y << 2u;
    }
    uint columns = voxels.x | voxels.y;
    columns = (columns | columns >> 16u) & 0xFFFFu;  // bit x + 4 y
    if (axis == 0) {
        columns |= columns >> 8u;
        return (columns | columns >> 4u) & 15u;
    }
    columns = (columns | columns >> 1u | columns >> 2u | columns >> 3u) & 0x1111u;
    return (columns | columns >> 3u | columns >> 6u | columns >> 9u) & 15u;
}

// The same for the block `aside` of a listed face's block; none outside of its cascade.
uint layersAside(ListedFace listed, ivec3 aside) {
    ivec3 block = listed.voxel + aside;
    if (block != clampToCascade(block, listed.voxel, frame.gridSide >> VCT_BRICK_LEVEL)) return 0u;
    uvec2 voxels = blockBits(block, listed.face, false);
    if (frame.hasDynamicObjects != 0) voxels |= blockBits(block, listed.face, true);
    return layersOf(voxels, listed.face >> 1);
}

// The layers of a brick that have faces, a bit for each: of the block and around it, 1 to 4, and in the
// border below and above these, 0 and 5.
uint layersInBrick(ListedFace listed) {
    ivec3 along = ivec3(fromAcross(vec2(0.0), 1.0, listed.face >> 1));
    uint layers = 0u;
    for (int i = 0; i < 9; ++i) {
        ivec3 aside = ivec3(fromAcross(vec2(i % 3, i / 3) - 1.0, 0.0, listed.face >> 1));
        layers |= layersAside(listed, aside) << 1u | layersAside(listed, aside - along) >> 3u |
                  (layersAside(listed, aside + along) & 1u) << 5u;
    }
    return layers;
}

// Takes a place for the brick of a block's face. Returns 0 if there is no room.
uint placeOf(ListedFace listed, int cascade) {
    BrickRoom room = lightStep.bricks[cascade];
    uint own = layersAside(listed, ivec3(0)) << 1u, layers = layersInBrick(listed);
    // Borders that the block's one layer does not touch are too far away to count.
    uint near = own << 1u | own | own >> 1u;
    bool isFlat = bitCount(own) == 1 && (layers & (near | 0x1Eu)) == own;
    if (isFlat) layers = own;
    uint first = uint(findLSB(layers)), count = uint(findMSB(layers)) - first + 1u;
    // A brick does not go on in the next column of the texture.
    uint along = uint(imageSize(brickTexels).x / VCT_BRICK_TEXELS), high = uint(imageSize(brickTexels).z);
    for (int attempt = 0; attempt < 3; ++attempt) {
        uint taken = atomicAdd(brickLayers[cascade], count);
        if (taken + count > room.layers) return 0u;
        uint place = room.firstLayer + taken, column = place / high, z = place % high;
        if (z + count <= high)
            return packBrick(uvec3(column % along, column / along, z), first, count) |
                   (isFlat ? VCT_BRICK_IS_FLAT : 0u);
    }
    return 0u;
}

// A word for the static walls of a listed face's brick. `at`: its texel.
uint staticWall(ListedFace listed, int slot, ivec3 at) {
#if VCT_CASCADES == 1
    return texelFetch(staticWalls, at, 0).r;
#else
    uint word = staticWallAt(listed.voxel, listed.face, slot);
    return word == 0u ? 0u : faceData[word];
#endif
}

void clearBrick(uint brick) {
    ivec3 first = firstTexel(brick);
    int layers = int(layersOfBrick(brick));
    for (int z = 0; z < layers; ++z)
        for (int y = 0; y < VCT_BRICK_TEXELS; ++y)
            for (int x = 0; x < VCT_BRICK_TEXELS; ++x)
                imageStore(brickTexels, first + ivec3(x, y, z), vec4(0.0));
}

void main() {
    const uint level = uint(VCT_BRICK_LEVEL);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ListedFace listed = listedFace(level, i);
        int cascade = listed.voxel.z / (frame.gridSide >> VCT_BRICK_LEVEL);
        if ((placed >> uint(cascade) & 1u) == 0u) continue;
        uint brick = placeOf(listed, cascade);
        if (brick != 0u) clearBrick(brick);
        ivec3 texel =
            faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, imageSize(brickPlaces).x / 3);
        for (int word = 0; word < 2; ++word) {
            ivec3 at = wallTexel(texel, word, imageSize(brickPlaces).z);
            uint ownWall = staticWall(listed, word, at);
            if (brick != 0u && ownWall != 0u) brick |= VCT_BRICK_HAS_WALLS;
            imageStore(walls, at, uvec4(ownWall));
        }
        imageStore(brickPlaces, texel, uvec4(brick));
    }
}
