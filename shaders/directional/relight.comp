// The base level in another light, where neither surfaces nor lists changed: the sums of each occupied voxel into the
// texels of its faces.
#include "directional/resolve.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    COUNT(VCT_COUNTER_FACE_RESOLVE);
    uint count = min(activeVoxelCount(level), voxelPlaces());
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint slot = gl_GlobalInvocationID.x; slot < count; slot += stride) {
        COUNT(VCT_COUNTER_FACE_RESOLVE_VOXEL);
        storeFaces(ivec3(activeVoxel(level, slot)), slot, markedFaces(slot));
    }
}
