// Nested cubes of voxels around the camera, for scenes too large for one cube (jni/engine/cascades.h).
// Cascade 0 is the finest, each is twice as wide as the one before, and the last one is the volume.
// VCT_CASCADES: their number; without it there is one, and these functions reduce to a product with
// frame.gridSide.
//
// The cascades lie one behind the other along z in all textures, in the lists of voxels and faces, and in
// "positions in voxels": those of cascade c have z from c * gridSide to (c + 1) * gridSide.
#include "shared/frame.glsl"

const int cascades = VCT_CASCADES;

// The cascade of a voxel.
int cascadeOf(ivec3 voxel) {
    return cascades == 1 ? 0 : voxel.z / frame.gridSide;
}

// The first voxel of a voxel's cascade. `side`: voxels along a side of a cascade, a power of two; this serves
// any mip level, and blocks of voxels.
ivec3 firstOfCascade(ivec3 voxel, int side) {
    return ivec3(0, 0, cascades == 1 ? 0 : voxel.z & ~(side - 1));
}

// The move of a cascade, in voxels, as packShift() packs it.
ivec3 unpackShift(uint shift) {
    return ivec3(int(shift << 22u) >> 22, int(shift << 12u) >> 22, int(shift << 2u) >> 22);
}

// True if a voxel or a block lies among those that have come into its cascade, or less than `reach` beside
// them or beside those that have left it. `arrived`: packShift() of the voxels that have come in along the
// cascade's lower and upper sides. `size`: of a block, in voxels, or 1.
bool isNearArrived(ivec3 place, int size, uvec2 arrived, int reach) {
    int side = frame.gridSide / size;
    ivec3 above = place - firstOfCascade(place, side), below = side - 1 - above;
    ivec3 lower = unpackShift(arrived.x) / size, upper = unpackShift(arrived.y) / size;
    bvec3 moved = greaterThan(lower + upper, ivec3(0));
    bvec3 isNear = greaterThan(max(lower - above, upper - below), ivec3(-reach));
    return moved.x && isNear.x || moved.y && isNear.y || moved.z && isNear.z;
}

// The voxel nearest to `wanted` in the cascade of `voxel`.
ivec3 clampToCascade(ivec3 wanted, ivec3 voxel, int side) {
    ivec3 first = firstOfCascade(voxel, side);
    return clamp(wanted, first, first + side - 1);
}

// Voxels of a cascade along the side of the volume.
float voxelsAlongVolume(int cascade) {
    return cascades == 1 ? float(frame.gridSide) : frame.cascade[cascade].w;
}

// Positions in volume space, from positions in voxels and back.
vec3 volumeFromVoxels(vec3 position, int cascade) {
    if (cascades == 1) return position / float(frame.gridSide);
    position.z -= float(cascade * frame.gridSide);
    return frame.cascade[cascade].xyz + position / frame.cascade[cascade].w;
}
vec3 voxelsFromVolume(vec3 positionVolume, int cascade) {
    if (cascades == 1) return positionVolume * float(frame.gridSide);
    vec3 position = (positionVolume - frame.cascade[cascade].xyz) * frame.cascade[cascade].w;
    return position + vec3(0.0, 0.0, float(cascade * frame.gridSide));
}

// The distance of a position (volume space) from the border of a cascade, in voxels of the cascade; negative
// outside of it.
float voxelsInside(vec3 positionVolume, vec4 cascade) {
    float halfSide = 0.5 * float(frame.gridSide);
    vec3 fromCentre = abs((positionVolume - cascade.xyz) * cascade.w - halfSide);
    return halfSide - max(fromCentre.x, max(fromCentre.y, fromCentre.z));
}

// Surfaces take their irradiance from the finest cascade around them. Over the last block of voxels inside
// of a cascade's border, the next one is mixed in.
struct LookUpCascade {
    int cascade;
    float share;  // of this cascade, 0..1; the rest is the share of the next one
};
LookUpCascade lookUpCascade(vec3 positionVolume) {
    // The filter of the look-up reaches one voxel aside.
    const float margin = 1.0, blend = 8.0;  // voxels
    for (int cascade = 0; cascade < cascades - 1; ++cascade) {
        float inside = voxelsInside(positionVolume, frame.cascade[cascade]) - margin;
        if (inside > 0.0) return LookUpCascade(cascade, min(inside / blend, 1.0));
    }
    return LookUpCascade(cascades - 1, 1.0);
}
