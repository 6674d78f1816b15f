// Clears the packed voxels that the last frame listed. OpenGL ES cannot clear a 3D texture, and writing every
// voxel would take longer than voxelization.
#include "shared/commands.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform uimage3D voxels;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    uint side = uint(imageSize(voxels).x);
    uint count = voxelsToClear(level, side);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ivec3 voxel = ivec3(voxelToClear(level, side, i));
        imageStore(voxels, voxel, uvec4(0u));
    }
}
