// Finds the thin walls that cross a floor, a ceiling or another wall, and writes them into the words of the
// bricks that these faces have (directional/walls.glsl). Static walls have words of their own, which stay as
// they are until the cascade moves; walls of dynamic objects are added to the bricks.
#include "directional/cascades.glsl"
#include "directional/face_lists.glsl"
#include "directional/voxels.glsl"
#include "directional/walls.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_DYNAMIC_VOXELS) uniform highp usampler3D dynamicIndex;
layout(r32ui, binding = VCT_IMAGE_BRICKS) coherent uniform highp uimage3D brickSlots;
layout(r32ui, binding = VCT_IMAGE_WALLS) coherent uniform highp uimage3D walls;  // static or of the bricks
layout(location = VCT_UNIFORM_LEVEL) uniform uint list;      // the list of the walls' faces
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit per cascade whose walls are marked

struct Cells {
    uint still;
    uint moving;
};

ivec3 unitVector(int axis) {
    return ivec3(equal(ivec3(axis), ivec3(0, 1, 2)));
}

// The faces of a voxel; none if it is outside of the cascade of the voxel `near`.
Cells cellsAt(ivec3 voxel, ivec3 near) {
    if (voxel != clampToCascade(voxel, near, frame.gridSide)) return Cells(0u, 0u);
    bool hasDynamic = frame.hasDynamicObjects != 0;
    return Cells(texelFetch(staticIndex, voxel, 0).r, hasDynamic ? texelFetch(dynamicIndex, voxel, 0).r : 0u);
}

// A face whose surface looks along the face's axis. Slanted surfaces have faces along several axes, which are
// neither walls nor crossed by them.
struct StraightFace {
    float coverage;  // 0: there is none
    float position;  // of the surface along the axis, from the middle of the voxel
};
StraightFace straightFace(Cells cells, int face) {
    // Walls of the static geometry's list are those without moving objects.
    bool isStatic = list != dynamicList;
    if (!hasFace(cells.still | (isStatic ? 0u : cells.moving), face)) return StraightFace(0.0, 0.0);
    uint id = surfaceId(cells.still, cells.moving, face, isStatic);
    SurfacePlane plane = facePlane(id);
    float along = plane.normal[face >> 1], coverage = faceExtent(id).coverage;
    return StraightFace(((face & 1) == 0 ? along : -along) > 0.9 ? coverage : 0.0, plane.offset / along);
}

// Writes a wall across `axis` into the words around the face `face` of `voxel`. `from`, `to`: the positions
// of the wall's two surfaces along the axis, in voxels.
void mark(ivec3 voxel, int face, int axis, float from, float to) {
    const float nearWall = 0.1;  // a texel so near to the wall may belong to either side
    ivec3 along = unitVector(axis);
    int faceAxis = face >> 1, other = 3 - faceAxis - axis;
    uint second = axis == (faceAxis + 1) % 3 ? 0u : 1u;
    int blocks = frame.gridSide >> VCT_BRICK_LEVEL;
    for (int beside = -1; beside <= 1; ++beside) {
        // The brick has a border of one texel, and the texels beside the wall may be in the next block.
        ivec3 block = (voxel >> VCT_BRICK_LEVEL) + beside * along;
        float first = float(block[axis] * VCT_BRICK_SIDE - 1);
        float middle = 0.5 * (from + to) - first;
        if (middle <= 0.5 || middle >= float(VCT_BRICK_TEXELS) - 0.5 ||
            block != clampToCascade(block, voxel >> VCT_BRICK_LEVEL, blocks))
            continue;
        ivec3 texel = faceTexel(block, faceAxis, face & 1, blocks);
        if (list == dynamicList && imageLoad(brickSlots, texel).r == 0u) continue;
        uint word = uint(middle * wallUnits + 0.5) << (8u * second);
        word |= layerBits(uint(voxel[other] & (VCT_BRICK_SIDE - 1))) << (16u + 6u * second);
        float texelMiddle = floor(middle) + 0.5;
        if (from - first < texelMiddle + nearWall && to - first > texelMiddle - nearWall)
            word |= 1u << (28u + second);
        if (list == dynamicList) imageAtomicOr(brickSlots, texel, VCT_BRICK_HAS_WALLS);
        // A failed attempt means that another wall has changed the word, which only gains bits and positions.
        // The limit is for drivers whose comparison never succeeds.
        uint before = imageLoad(walls, texel).r;
        for (int attempt = 0; attempt < 64 && mergeWalls(before, word) != before; ++attempt) {
            uint seen = imageAtomicCompSwap(walls, texel, before, mergeWalls(before, word));
            if (seen == before) break;
            before = seen;
        }
    }
}

void main() {
    uint count = faceCount(list);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ListedFace listed = listedFace(list, i);
        // A wall has two faces, and is found from the one that looks along its axis.
        if (list == 0u && listed.isMerged) continue;
        if ((listed.face & 1) != 0 || (moved >> uint(cascadeOf(listed.voxel)) & 1u) == 0u) continue;
        const float minCoverage = 0.25;
        int axis = listed.face >> 1;
        Cells cells = cellsAt(listed.voxel, listed.voxel);
        StraightFace front = straightFace(cells, listed.face);
        if (front.coverage < minCoverage) continue;
        // The back is in the same voxel or in the next one.
        StraightFace back = straightFace(cells, listed.face + 1);
        if (back.coverage < minCoverage) {
            back = straightFace(cellsAt(listed.voxel - unitVector(axis), listed.voxel), listed.face + 1);
            if (back.coverage < minCoverage) continue;
            back.position -= 1.0;
        }
        const float sheet = 0.05;  // the planes are rounded
        float thickness = front.position - back.position;
        if (thickness < -sheet || thickness > 1.0) continue;
        // The wall may cross a surface or stand at its edge, so the faces beside it tell.
        vec2 surfaces = float(listed.voxel[axis]) + 0.5 + vec2(back.position, front.position);
        for (int i = 0; i < 2; ++i) {
            ivec3 beside = listed.voxel;
            beside[axis] = int(floor(surfaces[i] + float(i) - 0.5));
            Cells besideCells = cellsAt(beside, listed.voxel);
            for (int turn = 2; turn < 6; ++turn) {
                // The wall stands in the voxel of the face that it crosses, or in the one in front of it.
                int face = (2 * axis + turn) % 6;
                ivec3 crossed = beside;
                if (straightFace(besideCells, face).coverage == 0.0) {
                    crossed -= (face & 1) == 0 ? unitVector(face >> 1) : -unitVector(face >> 1);
                    if (straightFace(cellsAt(crossed, listed.voxel), face).coverage == 0.0) continue;
                }
                mark(crossed, face, axis, surfaces.x, surfaces.y);
            }
        }
    }
}
