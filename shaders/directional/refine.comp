// At rest, traces rays that refine the mean of each face. Their hits are not kept. All faces trace the same
// directions at the same time, so that neighbours walk through the same voxels together.
#include "directional/face_rays.glsl"
#include "directional/visited.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

void main() {
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        FaceRays rays = raysOf(listed, id);
        vec4 sum = vec4(0.0);
        for (uint r = 0u; r < lightStep.refiningRays; ++r) {
            int number = directionNumber(int(lightStep.firstRefining + r));
            vec3 aroundNormal = gatherDirection(number), towards = rays.axes * aroundNormal;
            float distance;
            uint hit = traceFrom(rays, towards, rays.reach, number, allGeometry, distance);
            sum += skyOf(hit, skyAlong(towards, aroundNormal)) + vec4(radianceOf(hit), 0.0);
        }
        vec4 mean = sum / float(max(lightStep.refiningRays, 1u));
        vec4 gain = mean - faceMean(id, VCT_MEAN_NOW);
        storeFaceMean(id, VCT_MEAN_GAIN, mix(faceMean(id, VCT_MEAN_GAIN), gain, lightStep.refiningShare));
    }
}
