// One more bounce, second half: every face shines with its direct light and with what its block received.
#include "shared/trips.glsl"
#include "shared/commands.glsl"
#include "shared/face_bounce.glsl"
#include "shared/face_sums.glsl"
#include "shared/face_voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D slots;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    TRIP(VCT_TRIPS_BOUNCE);
    uint count = min(activeVoxelCount(level), faceSlots());
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint slot = gl_GlobalInvocationID.x; slot < count; slot += stride) {
        TRIP(VCT_TRIPS_BOUNCE_VOXEL);
        ivec3 voxel = ivec3(unpackEntry(activeVoxels[commands[level].firstEntry + slot]));
        uint block = texelFetch(slots, voxel >> 1, 1).r - 1u;
        for (int face = 0; face < 6; ++face) {
            FaceSum sum = faceSum(slot, face);
            if (sum.coverage == 0.0) continue;
            uvec2 halves = block < faceLightBlocks() ? faceLight[block * 6u + uint(face)] : uvec2(0u);
            vec3 light = vec3(unpackHalf2x16(halves.x), unpackHalf2x16(halves.y).x);
            vec3 radiance = sum.radiance + sum.albedo * light / frame.faces.y;
            ivec3 texel = faceTexel(voxel, face >> 1, face & 1, frame.grid.x);
            imageStore(faces, texel, storedFace(vec4(radiance, sum.coverage), texel));
        }
    }
}
