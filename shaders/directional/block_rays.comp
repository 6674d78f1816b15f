// Finds the cached rays of static faces that moving objects block, after a new pose. A ray that passes the
// sphere around an object is traced through the dynamic voxels, up to its cached hit.
#include "directional/face_rays.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// Up to four objects around a face, as its rays see them: the position of each in the frame of the surface
// (x, y and z of all four), and the least length of that position's projection onto a ray that passes it.
struct Objects {
    vec4 x, y, z, least;
    int count;
};

// The next objects that a face has to look for, from `i` on: those that fill at least about a thousandth of
// its hemisphere. `position`: of the face, in volume space.
Objects nextObjects(FaceRays rays, vec3 position, inout uint i) {
    const float smallest = 0.001;
    Objects found = Objects(vec4(0.0), vec4(0.0), vec4(0.0), vec4(1e9), 0);
    for (; i < lightStep.objectCount && found.count < 4; ++i) {
        vec3 offset = (lightStep.object[i].xyz - position) * rays.axes;
        float squared = dot(offset, offset), radius = lightStep.object[i].w;
        if (offset.y <= -radius || radius * radius <= smallest * squared) continue;
        float outside = squared - radius * radius;
        found.x = vec4(offset.x, found.x.xyz);
        found.y = vec4(offset.y, found.y.xyz);
        found.z = vec4(offset.z, found.z.xyz);
        found.least = vec4(outside > 0.0 ? sqrt(outside) : -1e9, found.least.xyz);
        ++found.count;
    }
    return found;
}

// A bit for each cached ray.
const int rayWords = (VCT_DIRECTIONS + 31) / 32;

// The cached rays that pass one of the objects.
uint[rayWords] raysPastObjects(FaceRays rays) {
    // From one cached direction to the next the azimuth turns by a constant angle.
    const float angle = 6.2831853 / float(VCT_GATHER_DIRECTIONS) * float(goldenStep);
    const vec2 turn = vec2(cos(angle), sin(angle));
    uint passing[rayWords];
    for (int w = 0; w < rayWords; ++w)
        passing[w] = 0u;
    vec3 position = volumeFromVoxels(rays.start, rays.cascade);
    for (uint i = 0u; i < lightStep.objectCount;) {
        Objects objects = nextObjects(rays, position, i);
        if (objects.count == 0) break;
        vec3 first = gatherDirection(cachedDirection(rays, 0u));
        vec2 around = first.xz / max(length(first.xz), 1e-6);
        for (uint d = 0u; d < uint(VCT_DIRECTIONS); ++d) {
            float sine = gatherSine(cachedDirection(rays, d)), cosine = sqrt(1.0 - sine * sine);
            vec4 along = objects.x * (around.x * sine) + objects.y * cosine + objects.z * (around.y * sine);
            if (any(greaterThan(along, objects.least))) passing[d >> 5u] |= 1u << (d & 31u);
            around = vec2(around.x * turn.x - around.y * turn.y, around.x * turn.y + around.y * turn.x);
        }
    }
    return passing;
}

// The distance from a ray's start to the plane of the face that it has hit; its reach if it hit none.
float distanceTo(uint hit, FaceRays rays, vec3 direction) {
    uint code = hit & ~VCT_HIT_NEAR;
    if (code < VCT_HIT_FACE) return rays.reach;
    ivec3 voxel = baseFace(code - VCT_HIT_FACE).voxel;
    int cascade = cascadeOf(voxel);
    SurfacePlane plane = facePlane(code - VCT_HIT_FACE);
    vec3 start = voxelsFromVolume(volumeFromVoxels(rays.start, rays.cascade), cascade);
    float distance = (plane.offset - dot(start - vec3(voxel) - 0.5, plane.normal)) /
                     min(dot(direction, plane.normal), -1e-3);
    return distance * voxelsAlongVolume(rays.cascade) / voxelsAlongVolume(cascade);
}

// The ends of the part of a ray that lies in the box around all moving objects, in voxels.
vec2 rangeOfObjects(FaceRays rays, vec3 direction) {
    vec3 inverse = 1.0 / mix(vec3(1e-5), direction, greaterThan(abs(direction), vec3(1e-5)));
    vec3 atLow = (voxelsFromVolume(lightStep.objectsLow.xyz, rays.cascade) - rays.start) * inverse;
    vec3 atHigh = (voxelsFromVolume(lightStep.objectsHigh.xyz, rays.cascade) - rays.start) * inverse;
    vec3 enters = min(atLow, atHigh), exits = max(atLow, atHigh);
    // Voxels that the objects touch reach beyond the box.
    return vec2(max(0.0, max(enters.x, max(enters.y, enters.z)) - 1.0),
                min(exits.x, min(exits.y, exits.z)) + 1.0);
}

// The nearest dynamic face that a cached ray meets before its hit.
uint traceObjects(FaceRays rays, vec3 direction, float reach, int number) {
    vec2 range = rangeOfObjects(rays, direction);
    float distance;
    rays.start += range.x * direction;
    rays.near -= range.x;
    return traceFrom(rays, direction, min(reach, range.y) - range.x, number, dynamicGeometry | backsOfFaces,
                     distance);
}

void main() {
    uint count = faceCount(0u);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint id = gl_GlobalInvocationID.x; id < count; id += stride) {
        uint at = irradianceAt(id) + VCT_FACE_BLOCKED;
        ListedFace listed = baseFace(id);
        // The rays of merged faces meet moving objects as they are traced.
        if (listed.isMerged || (faceIrradianceData[at + 1u] & wasMerged) != 0u) continue;
        FaceRays rays = raysOf(listed, id);
        // The rays that pass an object come first, and then their hits.
        uint passing[rayWords] = raysPastObjects(rays);
        uint blocked = 0u;
        for (int w = 0; w < rayWords; ++w)
            blocked += uint(bitCount(passing[w]));
        uint first = 0u, found = 0u, backs = 0u;
        if (blocked > 0u) {
            first = atomicAdd(blockedRays, blocked);
            atomicMax(mostBlockedRays, first + blocked);
            if (first + blocked > lightStep.blockedCapacity) blocked = 0u;
        }
        float rayCount = float(faceSight(id).rays);
        vec4 sky = faceMean(id, VCT_MEAN_SKY) * rayCount;
        for (int w = 0; w < rayWords && blocked > 0u; ++w)
            for (uint left = passing[w]; left != 0u; left &= left - 1u) {
                uint d = uint(32 * w + findLSB(left)), hit = cachedHit(id, d);
                if (!countsInMean(hit)) continue;
                int number = cachedDirection(rays, d);
                vec3 aroundNormal = gatherDirection(number), towards = rays.axes * aroundNormal;
                uint nearer = traceObjects(rays, towards, distanceTo(hit, rays, towards), number);
                if ((nearer & ~VCT_HIT_NEAR) == VCT_HIT_SKY) continue;
                faceIrradianceData[lightStep.firstBlocked + first + found] = packBlocked(d, nearer);
                ++found;
                vec3 skyThere = skyAlong(towards, aroundNormal);
                sky -= skyOf(hit, skyThere);
                if (countsInMean(nearer))
                    sky += skyOf(nearer, skyThere);
                else
                    ++backs;
            }
        faceIrradianceData[at] = lightStep.firstBlocked + first;
        storeBlockedCounts(id, found, backs, false);
        storeFaceMean(id, VCT_MEAN_SKY_NOW, max(sky, 0.0) / max(rayCount - float(backs), 1.0));
    }
}
