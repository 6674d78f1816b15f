// Finds the thin walls that cross a floor, a ceiling or another wall, and writes them into the words of the
// bricks that these faces have (directional/walls.glsl). Static walls have words of their own, with cascades
// in the pages of blocks, which stay while a cascade moves, so that those near new voxels are marked
// (list_arrived.comp); walls of dynamic objects are added to the bricks.
#include "directional/index.glsl"
#include "directional/visited.glsl"
#include "directional/voxels.glsl"
#include "directional/walls.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_BRICK_PLACES) coherent uniform highp uimage3D brickPlaces;
layout(r32ui, binding = VCT_IMAGE_WALLS) coherent uniform highp uimage3D walls;  // static or of the bricks
layout(location = VCT_UNIFORM_LIST) uniform uint list;  // the list of the walls' faces

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
    return Cells(staticCellAt(voxel), dynamicCellAt(voxel));
}

// A face's surface; a coverage of 0 if there is no face.
struct Surface {
    float coverage;
    vec2 place;  // middle of the covered part, across the face
    SurfacePlane plane;
};
Surface surfaceOf(Cells cells, int face) {
    // Walls of the static geometry's list are those without moving objects.
    bool isStatic = list != dynamicList;
    if (!hasFace(cells.still | (isStatic ? 0u : cells.moving), face))
        return Surface(0.0, vec2(0.0), SurfacePlane(vec3(0.0), 0.0));
    uint id = surfaceId(cells.still, cells.moving, face, isStatic);
    FaceExtent extent = faceExtent(id);
    return Surface(extent.coverage, extent.place, facePlane(id));
}

#if VCT_CASCADES > 1
// Adds a static wall to the word of a block's brick.
void markStatic(ivec3 block, int face, int slot, uint word) {
    uint at = staticWallAt(block, face, slot);
    if (at == 0u) return;
    uint before = faceData[at];
    for (int attempt = 0; attempt < 64 && mergeWalls(before, word) != before; ++attempt) {
        uint seen = atomicCompSwap(faceData[at], before, mergeWalls(before, word));
        if (seen == before) break;
        before = seen;
    }
}
#endif

// Adds a wall to the word of a block's brick. `slot`: the word of the two.
void markBrick(ivec3 block, int face, int slot, uint word) {
#if VCT_CASCADES > 1
    if (list != dynamicList) {
        markStatic(block, face, slot, word);
        return;
    }
#endif
    int blocks = frame.gridSide >> VCT_BRICK_LEVEL;
    ivec3 texel = faceTexel(block, face >> 1, face & 1, blocks);
    if (list == dynamicList && imageLoad(brickPlaces, texel).r == 0u) return;
    if (list == dynamicList) imageAtomicOr(brickPlaces, texel, VCT_BRICK_HAS_WALLS);
    // A failed attempt means that another wall has changed the word, which only grows. The limit is for
    // drivers whose comparison never succeeds.
    ivec3 at = wallTexel(texel, slot, blocks * cascades);
    uint before = imageLoad(walls, at).r;
    for (int attempt = 0; attempt < 64 && mergeWalls(before, word) != before; ++attempt) {
        uint seen = imageAtomicCompSwap(walls, at, before, mergeWalls(before, word));
        if (seen == before) break;
        before = seen;
    }
}

// Marks a wall that crosses the face `face` of `voxel` mostly along `axis`, in the bricks with texels beside
// it. `middle`: the plane amid the wall's two surfaces, from the middle of the voxel `wallVoxel`. Its normal
// has a positive component along the axis.
void mark(ivec3 voxel, int face, int axis, ivec3 wallVoxel, SurfacePlane middle, float thickness) {
    int faceAxis = face >> 1, other = 3 - faceAxis - axis;
    float steepness = 1.0 / middle.normal[axis];
    vec2 slope = -steepness * vec2(middle.normal[other], middle.normal[faceAxis]);
    // A texel whose middle is in the wall is of neither side. If one side of the wall looks the way of the
    // faces, it may have the faces of all voxels which the wall passes (splitByWall() in
    // directional/extents.comp).
    const float rounding = 0.1, perpendicular = 0.15;
    float inWall = 0.5 * thickness * steepness;
    float lean = (face & 1) == 0 ? middle.normal[faceAxis] : -middle.normal[faceAxis];
    float passed = inWall + 0.5 + 0.5 * (abs(slope.x) + abs(slope.y));
    float beside = inWall + rounding + 0.5 * abs(slope.x);
    ThinWall wall =
        ThinWall(0.0, lean < -perpendicular ? passed : beside, lean > perpendicular ? passed : beside, slope);
    vec3 wallMiddle = vec3(wallVoxel) + 0.5;
    float position = wallMiddle[axis] + steepness * middle.offset;  // at the middle of the wall's voxel
    ivec3 own = voxel >> VCT_BRICK_LEVEL;
    for (int i = 0; i < 27; ++i) {
        // Bricks have a border of one texel, and the texels beside the wall may be in the next block.
        ivec3 block = own + ivec3(i % 3, i / 3 % 3, i / 9) - 1;
        ivec3 texel = voxel - block * VCT_BRICK_SIDE + 1;
        texel[axis] = 1;
        bool isBeside = clamp(texel, ivec3(0), ivec3(VCT_BRICK_TEXELS - 1)) == texel;
        if (!isBeside || block[other] != own[other]) continue;
        vec3 first = vec3(block * VCT_BRICK_SIDE - 1);
        vec3 fromWall = first - wallMiddle;
        vec2 toTexel = vec2(texel[other], texel[faceAxis]) + 0.5,
             toWall = -vec2(fromWall[other], fromWall[faceAxis]);
        float inBrick = position - first[axis] + dot(wall.slope, toTexel - toWall);
        wall.position =
            position - first[axis] + dot(wall.slope, vec2(0.5 * float(VCT_BRICK_TEXELS)) - toWall);
        if (clamp(inBrick, 0.5 - wall.above, float(VCT_BRICK_TEXELS) - 0.5 + wall.below) != inBrick ||
            clamp(wall.position, wallPositions.x, wallPositions.y) != wall.position ||
            block != clampToCascade(block, own, frame.gridSide >> VCT_BRICK_LEVEL))
            continue;
        markBrick(block, face, axis == (faceAxis + 1) % 3 ? 0 : 1, packWall(wall, uint(texel[other] - 1)));
    }
}

// True if a wall crosses faces of `faceAxis` rather along `axis` than along the third axis. A wall that was
// marked along both would need both words of a brick.
bool isMostlyAlong(vec3 normal, int axis, int faceAxis) {
    int third = 3 - axis - faceAxis;
    float difference = abs(normal[axis]) - abs(normal[third]);
    return axis < third ? difference > -0.05 : difference >= 0.05;
}

// True if the part of a wall in a voxel reaches in front of a plane. `offset`: from the middle of the plane's
// voxel to that of the wall's. `axis`: of the wall's face.
bool reachesInFront(Surface wall, int axis, vec3 offset, SurfacePlane plane) {
    // The part is a rectangle of this size at most, and has its area.
    vec2 most = 1.0 - 2.0 * abs(wall.place), size = min(most, wall.coverage / max(most.yx, wall.coverage));
    vec2 change = acrossFaces(plane.normal, axis) -
                  acrossFaces(wall.plane.normal, axis) * (plane.normal[axis] / wall.plane.normal[axis]);
    vec3 middle = offset + pointOnPlane(wall.plane, axis, wall.place);
    const float rounding = 0.45;  // of the places and the planes
    return dot(plane.normal, middle) + 0.5 * dot(abs(change), size) > plane.offset + rounding;
}

// True if a wall crosses a surface that a voxel beside it or the one behind has at a face, and goes on in
// front of the surface. One that ends at the surface's back does not divide it. `voxel`: beside the wall,
// then the surface's. `near`: the wall's.
bool findCrossed(inout ivec3 voxel, int face, Surface wall, int axis, ivec3 near) {
    ivec3 towards = unitVector(face >> 1) * ((face & 1) == 0 ? 1 : -1);
    for (int behind = 0; behind < 2; ++behind) {
        ivec3 at = voxel - behind * towards;
        Surface surface = surfaceOf(cellsAt(at, near), face);
        if (surface.coverage > 0.0 && abs(dot(surface.plane.normal, wall.plane.normal)) < 0.7) {
            voxel = at;
            return behind == 1 || reachesInFront(wall, axis, vec3(near - at), surface.plane);
        }
    }
    return false;
}

void main() {
    uint count = list == 0u ? visitedFaceCount() : faceCount(list);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = list == 0u ? visitedFaceId(i) : commands[list].firstId + i;
        ListedFace listed = baseFace(id);
        if (list == 0u && (listed.isMerged || id >= commands[0].faceCapacity)) continue;
        // A wall has two faces, and is found from the one that looks along its axis.
        if ((listed.face & 1) != 0) continue;
        const float minCoverage = 0.25, minCosine = 0.4;
        int axis = listed.face >> 1;
        Cells cells = cellsAt(listed.voxel, listed.voxel);
        Surface front = surfaceOf(cells, listed.face);
        vec3 normal = front.plane.normal;
        if (front.coverage < minCoverage || normal[axis] < minCosine) continue;
        // The back is in the same voxel or in the next one.
        Surface back = surfaceOf(cells, listed.face + 1);
        if (back.coverage < minCoverage) {
            ivec3 behind = listed.voxel - unitVector(axis);
            back = surfaceOf(cellsAt(behind, listed.voxel), listed.face + 1);
            if (back.coverage < minCoverage) continue;
            back.plane.offset -= back.plane.normal[axis];
        }
        const float sheet = 0.05;  // the planes are rounded
        float thickness = front.plane.offset + back.plane.offset;
        if (dot(normal, back.plane.normal) > -0.97 || thickness < -sheet || thickness > 1.0) continue;
        SurfacePlane middle = SurfacePlane(normal, 0.5 * (front.plane.offset - back.plane.offset));
        // The wall may cross a surface or stand at its edge, so the faces beside it tell.
        vec2 surfaces =
            float(listed.voxel[axis]) + 0.5 + vec2(-back.plane.offset, front.plane.offset) / normal[axis];
        for (int side = 0; side < 2; ++side) {
            for (int turn = 2; turn < 6; ++turn) {
                int face = (2 * axis + turn) % 6;
                if (!isMostlyAlong(normal, axis, face >> 1)) continue;
                // In the nearest voxel the wall itself may have the face.
                ivec3 crossed = listed.voxel;
                for (int step = 0; step < 2; ++step) {
                    crossed[axis] =
                        int(floor(surfaces[side] + (side == 0 ? -0.5 - float(step) : 0.5 + float(step))));
                    if (findCrossed(crossed, face, front, axis, listed.voxel)) {
                        mark(crossed, face, axis, listed.voxel, middle, max(thickness, 0.0));
                        break;
                    }
                }
            }
        }
    }
}
