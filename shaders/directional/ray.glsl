// Rays through the directional voxels. A ray walks from voxel to voxel (Amanatides and Woo 1987), skips empty
// blocks of voxels, and ends where it meets the plane of a face that looks against it, inside of the face's
// voxel. So a wall blocks light however thin it is, and its two sides stay two surfaces. Lengths are in
// voxels.
#include "directional/face_data.glsl"
#include "directional/index.glsl"
#include "directional/voxels.glsl"
#include "shared/orthonormal.glsl"

layout(binding = VCT_TEX_BLOCKS) uniform highp usampler3D blocks;  // directional/fill_blocks.comp

const uint noFace = 0xFFFFFFFFu, backOfFace = 0xFFFFFFFEu;
// The geometry that a ray may meet. Backs of surfaces stop rays only where that is asked for.
const uint staticGeometry = 1u, dynamicGeometry = 2u, allGeometry = 3u, backsOfFaces = 4u;
// Height of a ray's start above its surface, because neighbouring voxels round a plane differently.
const float startHeight = 0.1;

// A number of 0..1 for surfaces that stop a share of the rays: a hash of the ray's number and its voxel.
float diceOf(int ray, ivec3 voxel) {
    return hashNoise(voxel, uint(ray)).x;
}

struct RayHit {
    uint id;         // of the face; noFace: the ray has met none; backOfFace: the back of one
    float distance;  // to the hit, or the length of the ray
};

// The tolerance at the borders of voxels and of planes. The planes of neighbouring voxels are rounded
// differently, and without it rays would slip between them.
const float acrossVoxel = 0.08, acrossPlane = 0.03;

// The index of the static geometry and that of the dynamic objects at a voxel.
struct VoxelCells {
    uint still, moving;
    uint atStill;  // a bit for each face whose surface is at the static id (directional/resolved.glsl)
};
VoxelCells cellsOf(ivec3 voxel, uint geometry) {
    uint still = staticCellAt(voxel), moving = dynamicCellAt(voxel);
    return VoxelCells(still, moving, (geometry & dynamicGeometry) == 0u ? still & ~moving : still);
}
uint faceOf(VoxelCells cells, int face) {
    return faceId(hasFace(cells.atStill, face) ? cells.still : cells.moving, face);
}

// True if a surface with this extent covers a point of its plane, both from the voxel's middle. `dice`: 0..1;
// a surface with an opacity below 1 stops the share of the rays.
bool covers(VoxelCells cells, int axis, uint surface, uint extentWord, vec3 point, float dice) {
    FaceExtent extent = unpackExtent(extentWord);
    for (uint left = extent.inFront ^ extent.behind; left != 0u; left &= left - 1u) {
        int face = findLSB(left);
        SurfacePlane other = facePlane(faceOf(cells, face));
        float above = dot(point, other.normal) - other.offset;
        if ((extent.inFront >> uint(face) & 1u) != 0u ? above < -acrossPlane : above > acrossPlane)
            return false;
    }
    if (surface >> 24u == 255u) return true;
    if ((extent.inFront | extent.behind) == 0u) {
        vec2 beside = abs(acrossFaces(point, axis) - extent.place) - 0.5 + abs(extent.place);
        if (max(beside.x, beside.y) > acrossPlane) return false;
    }
    return dice < opacityOf(surface) || surface >> 24u == opaqueInPart;
}

// The id of the face that goes on behind a thin wall, in the voxel beside or in the one behind or before
// that; noFace: unknown.
uint faceBehind(ivec3 voxel, int face, vec3 wallNormal) {
    ivec3 towards = voxelInFront(ivec3(0), face);
    vec3 normal = wallNormal * vec3(equal(towards, ivec3(0)));
    vec3 size = abs(normal);
    int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    ivec3 beside = voxel - ivec3(sign(normal) * vec3(equal(ivec3(axis), ivec3(0, 1, 2))));
    uint found = noFace;
    for (int n = 0; n < 3 && found == noFace; ++n) {
        ivec3 at = beside + towards * (n == 0 ? 0 : n == 1 ? -1 : 1);
        if (at != clampToCascade(at, voxel, frame.gridSide)) continue;
        uint cell = staticCellAt(at);
        if (hasFace(cell, face)) found = faceId(cell, face);
    }
    return found;
}

// The first face of a voxel that a ray meets.
struct FirstFace {
    int face;  // -1: the ray meets none
    bool isBack;
};
// `start`: of the ray. `reach`: limit of the distance, then that of the hit.
FirstFace firstFace(ivec3 voxel, uint geometry, vec3 start, vec3 direction, float dice, inout float reach) {
    VoxelCells cells = cellsOf(voxel, geometry);
    bool meetsBacks = (geometry & backsOfFaces) != 0u;
    vec3 origin = start - vec3(voxel) - 0.5;
    int first = -1;
    bool isBackFirst = false;
    float best = 0.0, limit = reach;
    uint faces = VCT_FACE_MASK & (((geometry & staticGeometry) != 0u ? cells.still : 0u) |
                                  ((geometry & dynamicGeometry) != 0u ? cells.moving : 0u));
    for (uint left = faces; left != 0u; left &= left - 1u) {
        int face = findLSB(left), axis = face >> 1;
        uint at = faceAt(faceOf(cells, face));
        uint surface = faceData[at + VCT_FACE_SURFACE];
        SurfacePlane plane = unpackPlane(surface);
        float cosine = dot(plane.normal, direction);
        if (meetsBacks ? abs(cosine) < 1e-4 : cosine > -1e-4) continue;
        float distance = (plane.offset - dot(origin, plane.normal)) / cosine;
        vec3 point = origin + distance * direction;
        float weight = abs(plane.normal[axis]);
        float beyond = max(abs(point.x), max(abs(point.y), abs(point.z))) - 0.5;
        bool isBack = cosine > 0.0;
        float across = isBack ? 0.0 : weight > 0.99 ? acrossPlane : acrossVoxel;
        if (distance < 0.0 || distance > limit || beyond > across) continue;
        // The faces of a slanted surface have the same plane, and so have the two sides of a sheet, of which
        // the front counts.
        float tie = isBack == isBackFirst ? 0.01 : 0.05;
        if (isBack) weight = 0.0;
        bool isNearer = distance < reach - tie || distance < reach + tie && weight > best;
        if (!isNearer) continue;
        if (!covers(cells, axis, surface, faceData[at + VCT_FACE_EXTENT], point, dice)) continue;
        reach = distance;
        best = weight;
        first = face;
        isBackFirst = isBack;
    }
    return FirstFace(first, isBackFirst);
}

// The id of a face that a ray meets at a point, in voxels.
uint idOfHit(ivec3 voxel, int face, uint geometry, vec3 point) {
    VoxelCells cells = cellsOf(voxel, geometry);
    uint id = faceId(hasFace(cells.still, face) ? cells.still : cells.moving, face);
    // Behind a thin wall the surface is of the face beside.
    WallFace wall = wallAcross(faceExtent(faceOf(cells, face)), voxel, face);
    if (wall.face < 0) return id;
    SurfacePlane plane = facePlane(faceOf(cellsOf(wall.voxel, geometry), wall.face));
    if (dot(point - vec3(wall.voxel) - 0.5, plane.normal) - plane.offset >= -acrossPlane) return id;
    uint behind = faceBehind(voxel, face, plane.normal);
    return behind != noFace ? behind : (geometry & backsOfFaces) != 0u ? backOfFace : id;
}

// The layers of the texture of occupied voxels that a ray reads: those from `first` on, and behind them by
// `dynamicLayers` those of the dynamic objects; 0: the ray reads one of both.
struct VoxelLayers {
    int first, dynamicLayers;
};
VoxelLayers layersOf(uint geometry) {
    int depth = frame.gridSide / VCT_BRICK_SIDE * cascades;
    bool readsStatic = (geometry & staticGeometry) != 0u;
    bool readsDynamic = (geometry & dynamicGeometry) != 0u && frame.hasDynamicObjects != 0;
    return VoxelLayers(readsStatic || !readsDynamic ? 0 : depth, readsStatic && readsDynamic ? depth : 0);
}

// The side of the largest empty cube, of 1, 2 or 4 voxels, that has a voxel; 0 if the voxel has faces that
// the ray may meet.
int emptySide(ivec3 voxel, VoxelLayers from) {
    ivec3 texel = (voxel >> VCT_BRICK_LEVEL) + ivec3(0, 0, from.first);
    uvec4 bits = texelFetch(blocks, texel, 0);
    if (from.dynamicLayers != 0) bits |= texelFetch(blocks, texel + ivec3(0, 0, from.dynamicLayers), 0);
    uint below = bits.x | bits.y << 16u, above = bits.z | bits.w << 16u;
    uint layers = (voxel.z & 2) == 0 ? below : above;
    uint place = uint((voxel.x & 3) | (voxel.y & 3) << 2 | (voxel.z & 1) << 4);
    bool isEmpty2 = (layers & 0x330033u << (place & 10u)) == 0u;
    int side = (below | above) == 0u ? 4 : isEmpty2 ? 2 : 1;
    return (layers >> place & 1u) != 0u ? 0 : side;
}

// A ray, in the directions of all cascades.
struct Ray {
    vec3 direction, inverse;
    vec3 ahead;  // 1 along the axes that it follows, 0 along those that it goes against
    float dice;
    uint geometry;
    VoxelLayers layers;
};

// Walks through one cascade from the distance `now`, to the first face before the distance `end`, or to where
// the ray leaves the cascade. `origin`: in voxels.
uint walk(Ray ray, vec3 origin, int cascade, float end, inout float now) {
    vec3 low = vec3(0.0, 0.0, float(cascade * frame.gridSide)), high = low + float(frame.gridSide);
    vec3 exits = (mix(low + 1e-3, high - 1e-3, ray.ahead) - origin) * ray.inverse;
    float exit = min(end, min(exits.x, min(exits.y, exits.z)));
    // A ray may begin outside, as before a surface at the border, and enter from there.
    vec3 enters = (mix(high - 1e-4, low + 1e-4, ray.ahead) - origin) * ray.inverse;
    float enter = max(now, max(enters.x, max(enters.y, enters.z)));
    if (enter < exit)
        now = enter;
    else
        exit = now;
    // The ray leaves a cube a little behind its border, so that it is past it in spite of rounding.
    vec3 leaves = mix(vec3(-1e-3), vec3(1.001), ray.ahead);
    ivec3 voxel = ivec3(origin + ray.direction * now);
    int side = now < exit ? emptySide(voxel, ray.layers) : 1;
    FirstFace first = FirstFace(-1, false);
    while (now < exit && first.face < 0) {
        // To the next voxel with a face.
        while (side != 0) {
            vec3 borders = (vec3(voxel & -side) + leaves * float(side) - origin) * ray.inverse;
            now = min(borders.x, min(borders.y, borders.z));
            if (!(now < exit)) break;
            voxel = ivec3(origin + ray.direction * now);
            side = emptySide(voxel, ray.layers);
        }
        if (side != 0) break;
        float found = end;
        first = firstFace(voxel, ray.geometry, origin, ray.direction, ray.dice, found);
        if (first.face >= 0) now = found;
        side = 1;
    }
    if (first.face < 0) return noFace;
    return first.isBack ? backOfFace : idOfHit(voxel, first.face, ray.geometry, origin + now * ray.direction);
}

// Traces a ray from `start`, in voxels of the cascade `own`, up to the distance `reach`, through some of the
// geometry. The direction has unit length. The ray goes on in the next coarser cascade where it leaves one.
RayHit traceRay(vec3 start, int own, vec3 direction, float reach, float dice, uint geometry) {
    // Each step goes on by at least a thousandth of a voxel, which floats resolve up to here. So every ray
    // ends.
    start = clamp(start, vec3(-4096.0), vec3(4096.0));
    direction = mix(vec3(1e-5), direction, greaterThan(abs(direction), vec3(1e-5)));  // no NaN either
    vec3 ahead = step(0.0, direction);
    Ray ray = Ray(direction, 1.0 / direction, ahead, dice, geometry, layersOf(geometry));
    float distance = 0.0;
#if VCT_CASCADES > 1
    vec3 volume = volumeFromVoxels(start, own);
    float scale = 1.0;
    for (int cascade = own; cascade < cascades && distance < reach; ++cascade, scale *= 0.5) {
        float now = distance * scale;
        uint id = walk(ray, voxelsFromVolume(volume, cascade), cascade, reach * scale, now);
        distance = now / scale;
        if (id != noFace) return RayHit(id, distance);
    }
    return RayHit(noFace, reach);
#else
    uint id = walk(ray, start, 0, reach, distance);
    return RayHit(id, id == noFace ? reach : distance);
#endif
}
