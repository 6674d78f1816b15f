// Empties what the last frame listed, of the base level: voxels, their faces and the faces' sums.
#include "directional/clear_voxel.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    COUNT(VCT_COUNTER_FACE_CLEAR_BASE);
    uint side = uint(frame.gridSide);
    uint count = voxelsToEmpty(level, side);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_FACE_CLEAR_BASE_VOXEL);
        ivec3 voxel = ivec3(voxelToEmpty(level, side, i));
        uint slot = overflowed(level) ? texelFetch(index, voxel, 0).r - 1u : i;
        imageStore(voxels, voxel, uvec4(0u));
        if (slot >= voxelPlaces()) continue;
        clearFaces(voxel, slot);
        setMarks(slot, 0u, 0u);
    }
}
