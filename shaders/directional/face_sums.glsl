// The sums of base-level faces: voxelization adds the fragments that cover a face. They are in fixed point.
// One unit is 1 / frame.faceSumUnits, chosen so that a sum over all triangles of the scene fits into 32 bits,
// as a triangle covers a face at most once.
//
// The sums of dynamic faces follow those of static ones. A static face has sums only while it is voxelized,
// because extents.comp keeps in the face's words what later poses need (keptSums()). If all of the static
// geometry is voxelized, the sums are in the order of the ids. After a move of cascades, the faces that are
// new share a small room, and until they have light the word of their radiance has their place in it.
#include "shared/frame.glsl"
#include "directional/face_data.glsl"
#include "directional/plane_points.glsl"
#include "shared/counts.glsl"

layout(std430, binding = VCT_SSBO_FACE_SUMS) buffer FaceSumBlock {
    uint faceSumData[];
};

#define VCT_FACE_PLANE 0u         // packPlane() of the fragment nearest to the voxel's middle; not a sum
#define VCT_FACE_FRONT 1u         // packPlane() of the foremost fragment; not a sum
#define VCT_FACE_FRONT_ALBEDO 2u  // packFrontAlbedo() of the foremost fragment; not a sum
#define VCT_FACE_COVERAGE 3u
#define VCT_FACE_ALBEDO 4u  // three words, weighted by coverage
#define VCT_FACE_PLACE 7u   // two words: position across the face (acrossFaces()), weighted by coverage
#define VCT_FACE_CURVE \
    9u  // four words of curved surfaces: coverage, and weighted by it the normal and the depth
#define VCT_FACE_EMISSION 13u  // three words, weighted by coverage, relative to frame.emissionRange

#ifdef VCT_EMISSION
const uint faceSumWords = VCT_EMISSIVE_FACE_SUM_WORDS;
#else
const uint faceSumWords = VCT_FACE_SUM_WORDS;
#endif

#if VCT_CASCADES == 1
// All static faces of one cube have sums, or none. A uniform says which, because these passes look up many
// sums. It is the first id that has sums; those of the others follow.
layout(location = VCT_UNIFORM_FIRST_SUMS) uniform uint firstWithSums;
uint sumsAt(uint id) {
    return (id - firstWithSums) * faceSumWords;
}
bool hasStaticSums(uint id) {
    return true;  // its static faces are resolved while they have sums
}
#else
// The position of a face's sums.
uint sumsAt(uint id) {
    uint capacity = commands[0].faceCapacity, place = id;
    if (id >= capacity)
        place = staticSums + id - capacity;
    else if (sumsById == 0u)
        place = max(faceData[radianceAt(id)], 1u) - 1u;
    return place * faceSumWords;
}
// False if a static face has no sums.
bool hasStaticSums(uint id) {
    return sumsById != 0u || faceData[radianceAt(id)] != 0u;
}
#endif

void addToWords(uint at, vec3 value) {
    uvec3 units = uvec3(clamp(value, 0.0, 1.0) * frame.faceSumUnits + 0.5);
    if (units.x != 0u) atomicAdd(faceSumData[at], units.x);
    if (units.y != 0u) atomicAdd(faceSumData[at + 1u], units.y);
    if (units.z != 0u) atomicAdd(faceSumData[at + 2u], units.z);
}

// The roots of a fragment's albedo, below its depth in the voxel, 0..1. So atomicMax() keeps the albedo of
// the foremost fragment.
uint packFrontAlbedo(float front, vec3 albedo) {
    return uint(front * 255.0 + 0.5) << 24 | packUnorm4x8(vec4(sqrt(albedo), 0.0));
}

struct FaceSums {
    float coverage;  // more than 1 if the voxel has several layers of surface
    vec3 albedo;     // weighted by coverage
    vec3 emission;   // weighted by coverage, relative to E/pi
    vec2 place;      // weighted by coverage: position across the face, 0..1
    uint plane;      // nearest to the voxel's middle
    uint front;      // foremost
    uint frontAlbedo;
    vec4 curve;  // of curved surfaces: coverage; weighted by it, normal across the face and depth, all 0..1
};

vec3 threeWords(uint at) {
    return vec3(uvec3(faceSumData[at], faceSumData[at + 1u], faceSumData[at + 2u])) / frame.faceSumUnits;
}

// Coverage, and the position across the face weighted by it.
vec3 coverageAndPlace(uint id) {
    uint at = sumsAt(id);
    return vec3(uvec3(faceSumData[at + VCT_FACE_COVERAGE], faceSumData[at + VCT_FACE_PLACE],
                      faceSumData[at + VCT_FACE_PLACE + 1u])) /
           frame.faceSumUnits;
}

FaceSums faceSums(uint id) {
    uint at = sumsAt(id);
    vec3 covered = coverageAndPlace(id);
    vec3 emission = vec3(0.0);
#ifdef VCT_EMISSION
    emission = threeWords(at + VCT_FACE_EMISSION) * frame.emissionRange;
#endif
    return FaceSums(covered.x, threeWords(at + VCT_FACE_ALBEDO), emission, covered.yz,
                    faceSumData[at + VCT_FACE_PLANE], faceSumData[at + VCT_FACE_FRONT],
                    faceSumData[at + VCT_FACE_FRONT_ALBEDO],
                    vec4(float(faceSumData[at + VCT_FACE_CURVE]) / frame.faceSumUnits,
                         threeWords(at + VCT_FACE_CURVE + 1u)));
}

// The sums of a static face that has no sums any more, as far as the words tell that extents.comp has written
// to `id`. They are those of one layer of surface.
FaceSums keptSums(uint id, int face) {
    uint at = faceAt(id), word = faceData[at + VCT_FACE_SURFACE];
    SurfacePlane plane = unpackPlane(word);
    FaceExtent extent = faceExtent(id);
    int axis = face >> 1;
    float coverage = extent.coverage, side = (face & 1) == 0 ? 1.0 : -1.0;
    vec3 middle = pointOnPlane(plane, axis, extent.place);
    float depth = clamp(middle[axis], -0.5, 0.5), front = 0.5 + side * depth;
    float nearness = max(1.0 - 0.6 * length(middle), 0.0);
    float key = nearness * (0.4 + 0.6 * abs(plane.normal[axis]));
    vec3 albedo = unpackRgb9e5(faceData[at + VCT_FACE_REFLECTANCE]), emission = vec3(0.0);
#ifdef VCT_EMISSION
    emission = unpackRgb9e5(faceData[at + VCT_FACE_EMITTED]);
#endif
    vec3 curve = vec3(0.5 + 0.5 * acrossFaces(plane.normal, axis), depth + 0.5);
    return FaceSums(coverage, coverage * albedo, coverage * emission, coverage * (extent.place + 0.5),
                    packPlane(key, extent.isCurved, plane.normal, plane.offset),
                    packPlane(front, extent.isCurved, plane.normal, plane.offset),
                    packFrontAlbedo(front, albedo),
                    extent.isCurved ? coverage * vec4(1.0, curve) : vec4(0.0));
}

FaceSums combine(FaceSums a, FaceSums b) {
    return FaceSums(a.coverage + b.coverage, a.albedo + b.albedo, a.emission + b.emission, a.place + b.place,
                    max(a.plane, b.plane), max(a.front, b.front), max(a.frontAlbedo, b.frontAlbedo),
                    a.curve + b.curve);
}

// True if several layers of surface, one behind the other, cover most of a face.
bool hasLayers(FaceSums sums) {
    return sums.coverage > 1.4;
}

// The albedo of what is seen from the face's side. Of several layers, as the ground below a floor, this is
// the foremost one.
vec3 visibleAlbedo(FaceSums sums) {
    vec3 front = unpackUnorm4x8(sums.frontAlbedo).rgb;
    return hasLayers(sums) ? front * front : sums.albedo / max(sums.coverage, 1e-4);
}

// True if two flat surfaces that look different ways share a face, and the foremost one hides the other. They
// are the outside of one wall and the inside of the next, along the edge of a box that is turned, and cover
// less of the face than a surface that goes on, as a ceiling above a wall. In a crease of a room, neither
// hides the other: the surface that is not the foremost one ends in front of that, and not behind it, which
// changes how much of the face the two cover.
bool hidesInside(FaceSums sums, int axis) {
    const float sameWay = 0.5, goesOn = 0.7;
    SurfacePlane plane = unpackPlane(sums.plane), front = unpackPlane(sums.front);
    float cosine = dot(plane.normal, front.normal);
    if (isCurved(sums.plane) || cosine > sameWay || sums.coverage > goesOn ||
        plane.offset * cosine > front.offset)
        return false;
    uint points = pointsInside(plane, axis), inFront = pointsInFront(plane, axis, points, front);
    float other = sums.coverage - coverageOf(pointsInFront(front, axis, pointsInside(front, axis), plane));
    return abs(other - coverageOf(points & ~inFront)) < abs(other - coverageOf(inFront));
}

// The plane of the surface that is seen from the face's side, as packPlane() packs it. Of several layers, or
// if it hides the inside of a box, this is the foremost one. A curved surface has the mean of its normals,
// through its middle.
uint visiblePlane(FaceSums sums, int face) {
    uint found = hasLayers(sums) || hidesInside(sums, face >> 1) ? sums.front : sums.plane;
    if (!isCurved(found) || hasLayers(sums) || sums.curve.x < 0.5 * sums.coverage) return found;
    int axis = face >> 1;
    vec3 mean = sums.curve.yzw / sums.curve.x;
    vec2 across = 2.0 * mean.xy - 1.0;
    float along = sqrt(max(1.0 - dot(across, across), 0.01));
    if ((face & 1) == 1) along = -along;
    vec3 normal = normalize(fromAcross(across, along, axis));
    vec3 middle = fromAcross(sums.place / sums.coverage - 0.5, mean.z - 0.5, axis);
    return packPlane(0.0, true, normal, dot(middle, normal));
}
