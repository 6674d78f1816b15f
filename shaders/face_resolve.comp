// The sums of every occupied voxel into its six faces.
#include "shared/trips.glsl"
#include "shared/commands.glsl"
#include "shared/face_sums.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    TRIP(VCT_TRIPS_FACE_RESOLVE);
    uint count = min(activeVoxelCount(level), faceSlots());
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint slot = gl_GlobalInvocationID.x; slot < count; slot += stride) {
        TRIP(VCT_TRIPS_FACE_RESOLVE_VOXEL);
        ivec3 voxel = ivec3(unpackEntry(activeVoxels[commands[level].firstEntry + slot]));
        for (int face = 0; face < 6; ++face) {
            FaceSum sum = faceSum(slot, face);
            if (sum.coverage == 0.0) continue;  // most are, and have been cleared
            ivec3 texel = faceTexel(voxel, face >> 1, face & 1, frame.grid.x);
            imageStore(faces, texel, storedFace(vec4(sum.radiance, sum.coverage), texel));
        }
    }
}
