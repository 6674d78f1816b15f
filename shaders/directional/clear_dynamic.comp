// Removes dynamic objects from the base level, before a new pose is voxelized: clears the faces that only
// they cover in the last pose, and the sums and the index of the pose before it, which the new pose will use.
// With cascades it does the same for the static geometry, before cascades that have moved are voxelized, and
// stores the radiance of the cleared faces, which carry_over.comp gives back to those that are still there.
#include "directional/face_sums.glsl"
#include "directional/cascades.glsl"
#include "directional/voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(binding = VCT_TEX_FACES) uniform mediump sampler3D facesBefore;
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform highp uimage3D index;  // index of the older pose
layout(location = VCT_UNIFORM_LIST) uniform uint last;                             // list of the last pose
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit for each cascade whose faces are cleared

void main() {
    COUNT(VCT_COUNTER_CLEAR_DYNAMIC);
    uint older = last ^ 1u;
    uint lastCount = faceCount(last), olderCount = faceCount(older);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < max(lastCount, olderCount); i += stride) {
        COUNT(VCT_COUNTER_CLEAR_DYNAMIC_FACE);
        if (i < lastCount) {
            ListedFace listed = listedFace(last, i);
            ivec3 texel = faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, frame.gridSide);
            bool isCleared = !listed.isMerged && (moved >> uint(cascadeOf(listed.voxel)) & 1u) != 0u;
            if (isCleared) {
                if (VCT_CASCADES > 1)
                    faceData[(commands[last].firstId + i) * faceWords + VCT_FACE_LAST_RADIANCE] =
                        packUnorm4x8(texelFetch(facesBefore, texel, 0));
                imageStore(faces, texel, vec4(0.0));
            }
        }
        if (i < olderCount) {
            imageStore(index, listedFace(older, i).voxel, uvec4(0u));
            uint at = (commands[older].firstId + i) * faceWords;
            for (uint word = 0u; word < faceWords; ++word)
                faceData[at + word] = 0u;
        }
    }
}
