// The rays of faces: where they begin, their directions, and what they hit.
#include "directional/face_lists.glsl"
#include "directional/ray.glsl"
#include "directional/face_irradiance.glsl"
#include "directional/gather_directions.glsl"
#include "directional/sky_light.glsl"

// A face as the origin of rays.
struct FaceRays {
    vec3 start;  // in voxels of the cascade
    int cascade;
    mat3 axes;  // the second one is the surface's normal
    ivec3 voxel;
    int place;          // of the face in its layer of the block, 0..15
    float reach, near;  // voxels: length of rays, and distance of ambient occlusion
};
// The height above a face's surface at which its rays begin, in voxels. It is in front of the voxel's other
// surfaces that look the same way, because the planes of a round surface lie behind one another.
float heightOfStart(ListedFace listed, uint id, SurfacePlane plane, vec3 middle) {
    const float sameWay = 0.5, limit = 0.6;
    float height = startHeight;
    uint cell = staticCellAt(listed.voxel);
    if (!hasFace(cell, listed.face) || faceId(cell, listed.face) != id) cell = dynamicCellAt(listed.voxel);
    for (uint left = cell & VCT_FACE_MASK & ~(1u << uint(listed.face)); left != 0u; left &= left - 1u) {
        SurfacePlane other = facePlane(faceId(cell, findLSB(left)));
        float cosine = dot(plane.normal, other.normal);
        float behind = other.offset - dot(middle - vec3(listed.voxel) - 0.5, other.normal);
        if (cosine > sameWay) height = max(height, startHeight + behind / cosine);
    }
    return min(height, limit);
}

FaceRays raysOf(ListedFace listed, uint id) {
    SurfacePlane plane = facePlane(id);
    int axis = listed.face >> 1, cascade = cascadeOf(listed.voxel);
    vec3 middle = surfaceMiddle(listed.voxel, listed.face, plane, faceExtent(id));
    vec3 start = middle + heightOfStart(listed, id, plane, middle) * plane.normal;
    float side = voxelsAlongVolume(cascade);
    return FaceRays(start, cascade, frameAround(plane.normal), listed.voxel, indexInBlock(listed.voxel, axis),
                    2.0 * side, frame.aoDistance * side);
}

// The step is odd, so that its multiples modulo the number of directions, a power of two, reach every
// direction.
const int goldenStep = (VCT_GATHER_DIRECTIONS * 618 / 1000) | 1;
// The number of a direction in the set. From one direction to the next the azimuth turns by about the golden
// angle, so that any few consecutive ones are spread over the hemisphere.
int directionNumber(int i) {
    return i * goldenStep & (VCT_GATHER_DIRECTIONS - 1);
}
// The squared sines of the angles between the normal and four successive directions.
vec4 gatherSquaredSines(int first) {
    // The number's bits are the first ones of the reversed ones.
    int otherBits = 32 - findMSB(VCT_GATHER_DIRECTIONS);
    uvec4 reversed = bitfieldReverse(uvec4((first + ivec4(0, 1, 2, 3)) * goldenStep)) >> otherBits;
    return (vec4(reversed) + 0.5) / float(VCT_GATHER_DIRECTIONS);
}
// The number of cached direction `d`. A block has 4^3 voxels, and one layer of it 4 x 4 faces. Their cached
// directions are different runs of the set, which together have all of its directions.
int cachedDirection(FaceRays rays, uint d) {
    return directionNumber(rays.place * VCT_DIRECTIONS + int(d));
}
uint traceFrom(FaceRays rays, vec3 direction, float reach, int number, uint geometry, out float distance) {
    RayHit hit = traceRay(rays.start, rays.cascade, direction, reach, diceOf(number, rays.voxel), geometry);
    distance = hit.distance;
    uint code = hit.id == noFace ? VCT_HIT_SKY : hit.id == backOfFace ? VCT_HIT_BACK : VCT_HIT_FACE + hit.id;
    return code | (hit.distance < rays.near ? VCT_HIT_NEAR : 0u);
}

// The sky's light along a direction.
vec3 skyAlong(vec3 direction, vec3 aroundNormal) {
    return skyLight(visibleSky(direction, gatherSolidAngle(aroundNormal.y)));
}

// The part of a face's mean that a ray adds besides the radiance of faces: the sky's light along it, and in
// alpha ambient visibility.
vec4 skyOf(uint hit, vec3 sky) {
    bool isSky = (hit & ~VCT_HIT_NEAR) == VCT_HIT_SKY;
    return vec4(isSky ? sky : vec3(0.0), (hit & VCT_HIT_NEAR) == 0u ? 1.0 : 0.0);
}

// The radiance of the face that a ray has hit; 0 if it has hit none.
vec3 radianceOf(uint hit) {
    uint code = hit & ~VCT_HIT_NEAR;
    return code >= VCT_HIT_FACE ? faceRadiance(code - VCT_HIT_FACE) : vec3(0.0);
}
