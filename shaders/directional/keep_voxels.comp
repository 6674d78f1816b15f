// Lists the static voxels of the cascades that have not moved, as they were in the last list.
#include "directional/cascades.glsl"
#include "directional/face_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform highp uimage3D index;
layout(binding = VCT_TEX_PREVIOUS_VOXELS) uniform highp usampler3D previousIndex;
layout(location = VCT_UNIFORM_LEVEL) uniform uint last;      // the last list
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit per cascade

void main() {
    COUNT(VCT_COUNTER_KEEP_VOXELS);
    uint count = activeVoxelCount(last);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_KEEP_VOXELS_VOXEL);
        ivec3 voxel = ivec3(activeVoxel(last, i));
        if ((moved >> uint(cascadeOf(voxel)) & 1u) != 0u) continue;
        imageStore(index, voxel, uvec4(texelFetch(previousIndex, voxel, 0).r & VCT_FACE_MASK));
        appendVoxel(staticList, uvec3(voxel));
    }
}
