// Computes the sky's part of each face's irradiance again from the cached hits, after the sky has changed.
#include "directional/face_rays.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

void main() {
    uint count = baseFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = baseFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        FaceRays rays = raysOf(listed, id);
        vec4 sky = vec4(0.0);
        for (uint d = 0u; d < uint(VCT_DIRECTIONS); ++d) {
            uint hit = cachedHit(id, d);
            vec3 aroundNormal = gatherDirection(cachedDirection(rays, d));
            if (countsInMean(hit)) sky += skyOf(hit, skyAlong(rays.axes * aroundNormal, aroundNormal));
        }
        sky /= max(float(faceSight(id).rays), 1.0);
        storeFaceMean(id, VCT_MEAN_SKY, sky);
    }
}
