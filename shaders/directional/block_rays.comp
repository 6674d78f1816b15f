// Finds the cached rays of static faces that moving objects block, after a new pose. A ray that passes the
// sphere around an object is traced through the dynamic voxels, up to its cached hit.
#include "directional/face_rays.glsl"
#include "directional/visited.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// A bit for each cached ray.
const int rayWords = (VCT_DIRECTIONS + 31) / 32;

// The cached rays that pass a sphere around an object, a bit for each of four successive ones from `first`
// on. `offset`: of its middle from the face, in the frame of the surface. `least`: the least length of the
// offset's projection onto a ray that passes it. `aroundX`, `aroundZ`: cosines and sines of the four
// azimuths.
uint raysPast(FaceRays rays, uint first, vec3 offset, float least, vec4 aroundX, vec4 aroundZ) {
    vec4 squaredSine = gatherSquaredSines(rays.place * VCT_DIRECTIONS + int(first));
    vec4 along =
        sqrt(squaredSine) * (offset.x * aroundX + offset.z * aroundZ) + offset.y * sqrt(1.0 - squaredSine);
    uvec4 bits = uvec4(greaterThan(along, vec4(least))) << uvec4(0u, 1u, 2u, 3u);
    return bits.x | bits.y | bits.z | bits.w;
}

// The cached rays that pass one of the objects that fill at least about a thousandth of the face's
// hemisphere.
uint[rayWords] raysPastObjects(FaceRays rays) {
    const float smallest = 0.001;
    // From one cached direction to the next the azimuth turns by a constant angle.
    const float angle = 6.2831853 / float(VCT_GATHER_DIRECTIONS) * float(goldenStep);
    const vec4 turns = angle * vec4(0.0, 1.0, 2.0, 3.0);
    uint passing[rayWords];
    for (int w = 0; w < rayWords; ++w)
        passing[w] = 0u;
    vec3 position = volumeFromVoxels(rays.start, rays.cascade);
    float start = 6.2831853 / float(VCT_GATHER_DIRECTIONS) * float(cachedDirection(rays, 0u));
    for (uint i = 0u; i < lightStep.objectCount; ++i) {
        vec3 offset = (lightStep.object[i].xyz - position) * rays.axes;
        float squared = dot(offset, offset), radius = lightStep.object[i].w;
        if (offset.y <= -radius || radius * radius <= smallest * squared) continue;
        float outside = squared - radius * radius, least = outside > 0.0 ? sqrt(outside) : -1e9;
        vec4 aroundX = cos(start + turns), aroundZ = sin(start + turns);
        for (uint d = 0u; d < uint(VCT_DIRECTIONS); d += 4u) {
            passing[d >> 5u] |= raysPast(rays, d, offset, least, aroundX, aroundZ) << (d & 31u);
            vec4 before = aroundX;
            aroundX = before * cos(4.0 * angle) - aroundZ * sin(4.0 * angle);
            aroundZ = before * sin(4.0 * angle) + aroundZ * cos(4.0 * angle);
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
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        if (id >= commands[0].faceCapacity) continue;
        uint at = irradianceAt(id) + VCT_FACE_BLOCKED;
        ListedFace listed = baseFace(id);
        // The rays of merged faces meet moving objects as they are traced.
        if (listed.isMerged || (faceIrradianceData[at + 1u] & wasMerged) != 0u) continue;
        FaceRays rays = raysOf(listed, id);
        // The rays that pass an object come first, and then their hits. The sky needs two more words.
        uint passing[rayWords] = raysPastObjects(rays);
        uint blocked = 0u;
        for (int w = 0; w < rayWords; ++w)
            blocked += uint(bitCount(passing[w]));
        uint first = 0u, found = 0u, backs = 0u;
        if (blocked > 0u) {
            uint words = blocked + 2u;
            first = atomicAdd(blockedRays, words);
            atomicMax(mostBlockedRays, first + words);
            if (first + words > lightStep.blockedCapacity) first = blocked = 0u;
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
        storeFirstBlocked(id, first);
        storeBlockedCounts(id, found, backs, false);
        if (found > 0u)
            storeMean(lightStep.firstBlocked + first + found,
                      max(sky, 0.0) / max(rayCount - float(backs), 1.0));
    }
}
