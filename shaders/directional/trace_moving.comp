// Traces some of the cached rays of moving objects' faces again. If these faces are few, several invocations
// share the rays of one. Each traces eight successive rays, whose hits lie in the same words.
#include "directional/trace_rays.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

shared TracedRays ofInvocation[VCT_LIST_GROUP];

void main() {
    uint again = movingRaysOfFace();
    uint invocations = max(again / 8u, 1u);  // of a face
    uint run = invocations == 1u ? again : 8u;
    uint faces = uint(VCT_LIST_GROUP) / invocations;  // of a work group
    uint own = gl_LocalInvocationIndex / invocations, part = gl_LocalInvocationIndex % invocations;
    uint count = faceCount(dynamicList);
    for (uint first = gl_WorkGroupID.x * faces; first < count; first += gl_NumWorkGroups.x * faces) {
        uint id = commands[dynamicList].firstId + first + own;
        bool traces = own < faces && first + own < count;
        ListedFace listed = ListedFace(ivec3(0), 0, true);
        if (traces) listed = baseFace(id);
        TracedRays traced = TracedRays(vec4(0.0), 0.0, ivec3(0));
        if (!listed.isMerged) {
            FaceRays rays = raysOf(listed, id);
            uint d = (lightStep.frame * invocations + part) * run;
            for (uint n = 0u; n < run; ++n)
                traceCached(rays, id, (d + n) % uint(VCT_DIRECTIONS), backsOfFaces | allGeometry, traced);
        }
        ofInvocation[gl_LocalInvocationIndex] = traced;
        memoryBarrierShared();
        barrier();
        if (part == 0u && !listed.isMerged) {
            for (uint n = 1u; n < invocations; ++n) {
                TracedRays other = ofInvocation[gl_LocalInvocationIndex + n];
                traced.sky += other.sky;
                traced.nearness += other.nearness;
                traced.count += other.count;
            }
            updateMeans(id, traced);
        }
        barrier();
    }
}
