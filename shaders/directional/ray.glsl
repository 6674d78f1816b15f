// Rays through the directional voxels. A ray walks from voxel to voxel (Amanatides and Woo 1987), skips empty
// blocks of voxels, and ends where it meets the plane of a face that looks against it, inside of the face's
// voxel. So a wall blocks light however thin it is, and its two sides stay two surfaces. Lengths are in
// voxels.
#include "directional/face_data.glsl"
#include "directional/voxels.glsl"
#include "shared/orthonormal.glsl"

layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_BLOCKS) uniform highp usampler3D blocks;  // directional/fill_blocks.comp
layout(binding = VCT_TEX_DYNAMIC_VOXELS) uniform highp usampler3D dynamicIndex;

const uint noFace = 0xFFFFFFFFu, backOfFace = 0xFFFFFFFEu;
// The geometry that a ray may meet. Backs of surfaces stop rays only where that is asked for, because more
// voxels have to be looked at.
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

// True if a surface with this extent covers a point of its plane, both from the voxel's middle. The cells are
// the voxel's. `dice`: 0..1; a surface with an opacity below 1 stops the share of the rays.
bool covers(uint staticCell, uint dynamicCell, bool isStatic, int axis, uint surface, uint extentWord,
            vec3 point, float dice) {
    FaceExtent extent = unpackExtent(extentWord);
    for (uint left = extent.inFront | extent.behind; left != 0u; left &= left - 1u) {
        int face = findLSB(left);
        SurfacePlane other = facePlane(surfaceId(staticCell, dynamicCell, face, isStatic));
        float above = dot(point, other.normal) - other.offset;
        if ((extent.inFront >> uint(face) & 1u) != 0u ? above < -acrossPlane : above > acrossPlane)
            return false;
    }
    if (surface >> 24u == 255u) return true;
    if ((extent.inFront | extent.behind) == 0u) {
        vec2 beside = abs(acrossFaces(point, axis) - extent.place) - 0.5 + abs(extent.place);
        if (max(beside.x, beside.y) > acrossPlane) return false;
    }
    return dice < opacityOf(surface);
}

// The id of the first face of a voxel that a ray meets. `origin`: of the ray, from the voxel's middle.
// `faces`: a bit for each face that the ray may meet. `meetsBacks`: whether their backs count. `reach`: limit
// of the distance, then that of the hit.
uint firstFace(uint staticCell, uint dynamicCell, bool isStatic, uint faces, bool meetsBacks, vec3 origin,
               vec3 direction, float dice, inout float reach) {
    uint id = noFace;
    float best = 0.0, limit = reach;
    for (uint left = faces; left != 0u; left &= left - 1u) {
        int face = findLSB(left), axis = face >> 1;
        uint at = faceAt(surfaceId(staticCell, dynamicCell, face, isStatic));
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
        float tie = isBack == (id == backOfFace) ? 0.01 : 0.05;
        if (isBack) weight = 0.0;
        bool isNearer = distance < reach - tie || distance < reach + tie && weight > best;
        if (!isNearer) continue;
        if (!covers(staticCell, dynamicCell, isStatic, axis, surface, faceData[at + VCT_FACE_EXTENT], point,
                    dice))
            continue;
        reach = distance;
        best = weight;
        id = isBack ? backOfFace : faceId(hasFace(staticCell, face) ? staticCell : dynamicCell, face);
    }
    return id;
}

// The voxels of a block with faces that a ray may meet. `set`: place of the set of such voxels.
uvec4 occupiedVoxels(ivec3 block, ivec2 set, uint geometry) {
    int side = frame.gridSide / VCT_BRICK_SIDE;
    ivec3 still = block + ivec3(set * side, 0);
    uvec4 bits = uvec4(0u);
    if ((geometry & staticGeometry) != 0u) bits |= texelFetch(blocks, still, 0);
    if ((geometry & dynamicGeometry) != 0u && frame.hasDynamicObjects != 0)
        bits |= texelFetch(blocks, still + ivec3(0, 0, side * cascades), 0);
    return bits;
}

// Traces a ray from `start`, in voxels of the cascade `own`, up to the distance `reach`, through some of the
// geometry. The direction has unit length. The ray goes on in the next coarser cascade where it leaves one.
RayHit traceRay(vec3 start, int own, vec3 direction, float reach, float dice, uint geometry) {
    direction = mix(direction, vec3(1e-5), lessThan(abs(direction), vec3(1e-5)));
    vec3 inverse = 1.0 / direction;
    bvec3 positive = greaterThan(direction, vec3(0.0));
    ivec3 ahead = ivec3(positive);
    uint against = (positive.x ? 2u : 1u) | (positive.y ? 8u : 4u) | (positive.z ? 32u : 16u);
    bool meetsBacks = (geometry & backsOfFaces) != 0u;
    ivec2 set = placeOfSet(meetsBacks ? allFaces : ahead.x + 2 * ahead.y + 4 * ahead.z);
    if (meetsBacks) against = VCT_FACE_MASK;
    vec3 volume = volumeFromVoxels(start, own);
    float scale = 1.0, distance = 0.0;
    for (int cascade = own; cascade < cascades; ++cascade, scale *= 0.5) {
        vec3 origin = voxelsFromVolume(volume, cascade);
        ivec3 low = ivec3(0, 0, cascade * frame.gridSide), high = low + frame.gridSide - 1;
        float now = distance * scale, end = reach * scale;
        ivec3 voxel = clamp(ivec3(floor(origin + direction * (now + 1e-4))), low, high);
        bool isInside = true, isTested = false;  // the ray has met no face in the voxel
        while (isInside && now < end) {
            // Walk to the next voxel with a face that looks against the ray.
            bool isOccupied = false;
            do {
                uvec4 bits = occupiedVoxels(voxel >> VCT_BRICK_LEVEL, set, geometry);
                uint place = uint((voxel.x & 3) + 4 * (voxel.y & 3));
                uvec2 layers = (voxel.z & 2) == 0 ? bits.xy : bits.zw;
                uint layer = (voxel.z & 1) == 0 ? layers.x : layers.y;
                isOccupied = !isTested && (layer >> place & 1u) != 0u;
                if (!isOccupied) {
                    // To the border of the largest empty cube, of 1, 2 or 4 voxels, that has the voxel.
                    bool isEmpty2 = ((layers.x | layers.y) & 0x33u << (place & 10u)) == 0u;
                    int side = (bits.x | bits.y | bits.z | bits.w) == 0u ? 4 : isEmpty2 ? 2 : 1;
                    ivec3 first = voxel & -side;
                    vec3 borders = (vec3(first + ahead * side) - origin) * inverse;
                    now = min(borders.x, min(borders.y, borders.z));
                    // The ray leaves along exactly one axis whatever the borders are, NaN too, so it ends.
                    bool leavesX = borders.x == now, leavesY = !leavesX && borders.y == now;
                    bvec3 leaves = bvec3(leavesX, leavesY, !leavesX && !leavesY);
                    ivec3 within = clamp(ivec3(floor(origin + direction * now)), first, first + side - 1);
                    ivec3 beyond = mix(first - 1, first + side, positive);
                    voxel = mix(within, beyond, leaves);
                    isInside = all(greaterThanEqual(voxel, low)) && all(lessThanEqual(voxel, high));
                    isTested = false;
                }
            } while (!isOccupied && isInside && now < end);
            if (!isOccupied) break;
            uint staticCell = texelFetch(staticIndex, voxel, 0).r;
            uint dynamicCell = frame.hasDynamicObjects != 0 ? texelFetch(dynamicIndex, voxel, 0).r : 0u;
            float found = end;
            uint faces = ((geometry & staticGeometry) != 0u ? staticCell : 0u) |
                         ((geometry & dynamicGeometry) != 0u ? dynamicCell : 0u);
            bool isStatic = (geometry & dynamicGeometry) == 0u;
            uint id = firstFace(staticCell, dynamicCell, isStatic, faces & against, meetsBacks,
                                origin - vec3(voxel) - 0.5, direction, dice, found);
            if (id != noFace) return RayHit(id, found / scale);
            isTested = true;
        }
        distance = now / scale;
        if (distance >= reach) break;
    }
    return RayHit(noFace, reach);
}
