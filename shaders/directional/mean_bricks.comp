// Writes the mean irradiance of the faces of each brick, for surfaces that are so thin that the voxels around
// them have no faces (directional/irradiance.glsl).
#include "directional/face_lists.glsl"
#include "directional/irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba16f, binding = VCT_IMAGE_IRRADIANCE) writeonly uniform mediump image3D irradianceTexels;

void main() {
    uint count = faceCount(uint(VCT_BRICK_LEVEL));
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ListedFace listed = listedFace(uint(VCT_BRICK_LEVEL), i);
        uint brick = brickAt(listed.voxel, listed.face >> 1, listed.face & 1);
        if (brick == 0u) continue;
        // The filter reads eight faces of a full brick at each of eight places, or four of a flat one at
        // four.
        bool isFlat = (brick & VCT_BRICK_IS_FLAT) != 0u;
        vec4 sum = vec4(0.0);
        for (uint corner = 0u; corner < (isFlat ? 4u : 8u); ++corner) {
            vec3 inBrick = 3.0 + 2.0 * cornerOffset(corner);
            sum += filteredTexel(vec3(firstTexel(brick)) + (isFlat ? vec3(inBrick.xy, 0.5) : inBrick));
        }
        // A flat brick that is covered whole has 1.
        sum *= isFlat ? 0.25 : 0.5;
        imageStore(irradianceTexels, meanTexel(brick), min(sum, vec4(maxMean)));
    }
}
