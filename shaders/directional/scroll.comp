// Lists the static voxels that the cascades still hold after they have moved, of those that
// unlist_static.comp has found. Their faces keep their ids, and their blocks keep their pages. The ids of the
// other faces are free from the next move on; until then they lead to the face of the next cascade in the
// same place (faceInstead()), and keep their radiance. Only with cascades.
#include "directional/block_lists.glsl"
#include "directional/index.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_SHIFT) uniform uint shifts[VCT_MAX_CASCADES];  // packShift() of each cascade

// The id, counted from 1, of the face of the next coarser cascade where a voxel is; 0: none. The voxel may be
// outside of its cascade, whose number is `own`.
uint idInNextCascade(ivec3 voxel, int own, int face) {
    if (own + 1 >= cascades || shifts[own + 1] != 0u) return 0u;
    vec3 middle = volumeFromVoxels(vec3(voxel) + 0.5, own);
    ivec3 next = ivec3(floor(voxelsFromVolume(middle, own + 1)));
    if (next != clampToCascade(next, ivec3(0, 0, (own + 1) * frame.gridSide), frame.gridSide)) return 0u;
    uint cell = staticCellAt(next);
    return hasFace(cell, face) ? faceId(cell, face) + 1u : 0u;
}

void main() {
    uint count = faceCount(uint(VCT_LIST_VISITED)), total = faceCount(0u), list = commands[0].firstFace;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = faceData[commands[VCT_LIST_VISITED].firstFace + i], entry = faceData[list + id];
        ivec3 voxel = unpackListed(entry).voxel;
        int own = cascadeOf(voxel);
        ivec3 now = voxel - unpackShift(shifts[own]);
        bool stays = now == clampToCascade(now, voxel, frame.gridSide);
        // The other faces of the voxel follow, without the mark of a first face.
        uint faces = 0u, size = 0u;
        do {
            int face = int(unpackFace(entry));
            faces |= 1u << uint(face);
            if (stays) {
                storeListed(0u, id + size, now, face, entry & VCT_FIRST_FACE);
            } else {
                faceData[list + id + size] = VCT_FREE_FACE;
                faceData[faceAt(id + size) + VCT_FACE_INSTEAD] = idInNextCascade(now, own, face);
            }
            ++size;
            entry = id + size < total ? faceData[list + id + size] : VCT_FREE_FACE;
        } while (size < 6u && (entry & VCT_FIRST_FACE) == 0u);
        if (stays) {
            atomicAdd(commands[0].voxelCount, 1u);
            uint shift, at = maskAt(now >> VCT_BRICK_LEVEL, shift);
            atomicOr(faceData[at], faces << shift);
            continue;
        }
        for (uint word = 0u; word < 2u; ++word) {
            uint bits = bitsOfIds(id, size, word);
            if (bits == 0u) continue;
            atomicAnd(faceData[freshAt(id) + word], ~bits);
            atomicOr(faceData[goneAt(id) + word], bits);
        }
    }
}
