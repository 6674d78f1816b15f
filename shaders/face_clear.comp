// Zeroes the faces of the last frame's voxels of one level, found through its list, and with the base level the sums.
#include "shared/trips.glsl"
#include "shared/commands.glsl"
#include "shared/face_sums.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    TRIP(VCT_TRIPS_FACE_CLEAR);
    uint count = activeVoxelCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    int grid = imageSize(faces).z;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_FACE_CLEAR_VOXEL);
        ivec3 voxel = ivec3(unpackEntry(activeVoxels[commands[level].firstEntry + i]));
        for (int face = 0; face < 6; ++face) {
            if (level == 0u) {
                uint index = faceSumIndex(i, face);
                if (i >= faceSlots() || faceSums[index] == 0u) continue;  // nothing was written
                for (uint word = 0u; word < VCT_FACE_SUM_WORDS; ++word) {
                    TRIP(VCT_TRIPS_FACE_CLEAR_WORD);
                    faceSums[index + word] = 0u;
                }
            }
            imageStore(faces, faceTexel(voxel, face >> 1, face & 1, grid), vec4(0.0));
        }
    }
}
