// Where voxels were made anew: faces without a memory of their own begin with what was received where they are.
#include "shared/counters.glsl"
#include "directional/face_list.glsl"
#include "directional/irradiance.glsl"
#include "directional/received.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D index;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    COUNT(VCT_COUNTER_LIGHT_INHERIT);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = lightStep.firstNew + gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_LIGHT_INHERIT_FACE);
        ListedFace listed = listedFace(level, i);
        uint slot = texelFetch(index, listed.voxel, 0).r - 1u;
        vec4 found = vec4(0.0);
        if (slot < voxelPlaces() && lightStep.inherited > 0.0) {
            // Its own, where it was there before; filtered again and again it would be others'.
            ivec3 block = listed.voxel >> VCT_BRICK_LEVEL;
            uint brick = brickAt(block, listed.face >> 1, listed.face & 1);
            ivec3 own = unpackBrick(brick) * VCT_BRICK_TEXELS + listed.voxel - block * VCT_BRICK_SIDE + 1;
            found = texelFetch(irradiance, own, 0) * float(brick >> 31);
            SurfacePlane plane = facePlane(slot, listed.face);
            vec3 position = vec3(listed.voxel) + 0.5 + plane.normal * plane.offset;
            if (found.a == 0.0) found = receivedByFaces(position, block, listed.face >> 1, listed.face & 1);
        }
        float steps = found.a > 0.003 ? lightStep.inherited : 0.0;
        vec3 light = steps > 0.0 ? found.rgb / found.a : vec3(0.0);
        storeReceived(i, Received(light, steps, light, 0.0));
    }
}
