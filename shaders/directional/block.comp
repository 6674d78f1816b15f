// Finds the cached rays of static faces that moving objects block, after a new pose. A ray that passes the
// sphere around an object is traced through the dynamic voxels, up to its cached hit.
#define VCT_RAY_STEP VCT_COUNTER_BLOCK_STEP
#define VCT_RAY_FACE VCT_COUNTER_BLOCK_VOXEL_FACE
#define VCT_RAY_LIMIT VCT_COUNTER_BLOCK_LIMIT
#include "directional/face_rays.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// A bit for each object.
const int objectWords = VCT_MAX_OBJECTS / 32;

// The objects that a face has to look for, a bit for each: those that fill at least about a thousandth of its
// hemisphere, or more if there are many objects. `position`: volume space.
uint[objectWords] objectsBefore(vec3 position, vec3 normal) {
    float smallest = 0.001 * max(1.0, float(lightStep.objectCount) / 8.0);
    uint found[objectWords];
    for (int w = 0; w < objectWords; ++w)
        found[w] = 0u;
    for (uint i = 0u; i < lightStep.objectCount; ++i) {
        COUNT(VCT_COUNTER_BLOCK_OBJECT);
        vec3 offset = lightStep.object[i].xyz - position;
        float squared = dot(offset, offset), radius = lightStep.object[i].w;
        if (dot(offset, normal) > -radius && radius * radius > smallest * squared)
            found[i / 32u] |= 1u << (i % 32u);
    }
    return found;
}

// True if a ray passes one of the objects.
bool passes(uint objects[objectWords], vec3 position, vec3 direction) {
    for (int w = 0; w < objectWords; ++w)
        for (uint left = objects[w]; left != 0u; left &= left - 1u) {
            COUNT(VCT_COUNTER_BLOCK_OBJECT_RAY);
            vec4 object = lightStep.object[32 * w + findLSB(left)];
            vec3 offset = object.xyz - position;
            vec3 aside = offset - max(dot(offset, direction), 0.0) * direction;
            if (dot(aside, aside) < object.w * object.w) return true;
        }
    return false;
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

void main() {
    COUNT(VCT_COUNTER_BLOCK);
    uint count = faceCount(listOfStatic());
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_BLOCK_FACE);
        uint id = firstStaticId() + i, at = irradianceAt(id) + VCT_FACE_BLOCKED;
        // The rays of merged faces meet moving objects as they are traced.
        if ((faceIrradianceData[at + 1u] & wasMerged) != 0u) continue;
        FaceRays rays = raysOf(baseFace(id), id);
        vec3 position = volumeFromVoxels(rays.start, rays.cascade);
        uint objects[objectWords] = objectsBefore(position, rays.axes[1]);
        // The rays that pass an object come first, and then their hits. A few words hold their bits.
        bool any = false;
        for (int w = 0; w < objectWords; ++w)
            any = any || objects[w] != 0u;
        uint passing[(VCT_DIRECTIONS + 31) / 32], blocked = 0u;
        for (int w = 0; w < passing.length(); ++w) {
            passing[w] = 0u;
            for (int b = 0; b < min(32, VCT_DIRECTIONS - 32 * w) && any; ++b) {
                COUNT(VCT_COUNTER_BLOCK_RAY);
                vec3 towards = rays.axes * gatherDirection(cachedDirection(rays, uint(32 * w + b)));
                if (passes(objects, position, towards)) passing[w] |= 1u << b;
            }
            blocked += uint(bitCount(passing[w]));
        }
        uint first = 0u, found = 0u, backs = 0u;
        if (blocked > 0u) {
            first = atomicAdd(blockedRays, blocked);
            atomicMax(mostBlockedRays, first + blocked);
            if (first + blocked > lightStep.blockedCapacity) blocked = 0u;
        }
        float rayCount = float(faceSight(id).rays);
        vec4 sky = faceMean(id, VCT_MEAN_SKY) * rayCount;
        for (int w = 0; w < passing.length() && blocked > 0u; ++w)
            for (uint left = passing[w]; left != 0u; left &= left - 1u) {
                uint d = uint(32 * w + findLSB(left)), hit = faceIrradianceData[hitAt(id, d)];
                if (!countsInMean(hit)) continue;
                COUNT(VCT_COUNTER_BLOCK_TRACE);
                int number = cachedDirection(rays, d);
                vec3 aroundNormal = gatherDirection(number), towards = rays.axes * aroundNormal;
                float distance;
                uint nearer = traceFrom(rays, towards, distanceTo(hit, rays, towards), number,
                                        dynamicGeometry | backsOfFaces, distance);
                if ((nearer & ~VCT_HIT_NEAR) == VCT_HIT_SKY) continue;
                faceIrradianceData[lightStep.firstBlocked + first + found] = packBlocked(d, nearer);
                ++found;
                sky -= skyOf(hit, towards, aroundNormal);
                if (countsInMean(nearer))
                    sky += skyOf(nearer, towards, aroundNormal);
                else
                    ++backs;
            }
        faceIrradianceData[at] = lightStep.firstBlocked + first;
        faceIrradianceData[at + 1u] = packBlockedCounts(found, backs);
        storeFaceMean(id, VCT_MEAN_SKY_NOW, max(sky, 0.0) / max(rayCount - float(backs), 1.0));
    }
}
