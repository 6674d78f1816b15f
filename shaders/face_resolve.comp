// The sums of every occupied voxel into its six faces; the sums are zero again afterwards, for the next frame.
#include "shared/commands.glsl"
#include "shared/face_sums.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

vec3 takeThree(uint index) {
    vec3 value = vec3(uvec3(faceSums[index], faceSums[index + 1u], faceSums[index + 2u]));
    faceSums[index] = faceSums[index + 1u] = faceSums[index + 2u] = 0u;
    return value;
}

void main() {
    uint count = min(activeVoxelCount(level), faceSlots());
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint slot = gl_GlobalInvocationID.x; slot < count; slot += stride) {
        ivec3 voxel = ivec3(unpackEntry(activeVoxels[commands[level].firstEntry + slot]));
        for (int face = 0; face < 6; ++face) {
            uint index = faceSumIndex(slot, face);
            float sum = float(faceSums[index]);
            vec4 value = vec4(0.0);
            if (sum > 0.0) {
                faceSums[index] = 0u;
                // More than one layer of surface in a voxel: it is covered, and shines with their mean.
                float scale = 1.0 / max(sum, frame.faces.x);
                value = vec4(takeThree(index + VCT_FACE_SUM_RADIANCE), sum) * scale;
                takeThree(index + VCT_FACE_SUM_ALBEDO);
            }
            imageStore(faces, faceTexel(voxel, face >> 1, face & 1, frame.grid.x), value);
        }
    }
}
