// One mip level of the faces from the one below, over that level's faces that are not empty: of each of the four pairs
// of children along the face's axis the front one over the back one, and the mean of the pairs. A wall across the
// voxel stays opaque at every level, and is seen from one side only. VCT_LIST_PARENTS: makes the next level's lists too;
// they last until the scene is voxelized again. VCT_PART: of a part of the faces; the parents of what does not move are
// listed; and the level behind the next is emptied of what moved.
#include "shared/counters.glsl"
#include "directional/face_list.glsl"
#ifdef VCT_LIST_PARENTS
#include "directional/face_parents.glsl"
#endif
#include "directional/voxels.glsl"
#ifdef VCT_PART
#include "directional/dynamic_faces.glsl"
#endif

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_FACES) uniform mediump sampler3D faces;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D means;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // of the parents
#ifdef VCT_LIST_PARENTS
const uint which = 0u;  // storedFace()'s
#else
layout(location = VCT_UNIFORM_WHICH) uniform uint which;
#endif

void main() {
    COUNT(VCT_COUNTER_FACE_MIPMAPPER);
    uint count = visitedFaces(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    int childGrid = textureSize(faces, int(level) - 1).z;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_FACE_MIPMAPPER_FACE);
        ListedFace listed = visitedFace(level, i);
        int axis = listed.face >> 1, side = listed.face & 1;
        ivec3 along = ivec3(axis == 0, axis == 1, axis == 2);
        ivec3 across = along.zxy;
        ivec3 third = along.yzx;
        vec4 sum = vec4(0.0);
        for (int pair = 0; pair < 4; ++pair) {
            ivec3 near = listed.voxel * 2 + across * (pair & 1) + third * (pair >> 1) + along * (1 - side);
            ivec3 far = near - along * (1 - 2 * side);
            vec4 front = texelFetch(faces, faceTexel(near, axis, side, childGrid), int(level) - 1);
            vec4 back = texelFetch(faces, faceTexel(far, axis, side, childGrid), int(level) - 1);
            sum += front + (1.0 - front.a) * back;
        }
        ivec3 texel = faceTexel(listed.voxel, axis, side, childGrid >> 1);
        imageStore(means, texel, storedFace(sum * 0.25, texel, which));
#ifdef VCT_LIST_PARENTS
#ifdef VCT_PART
        if (!isMoving(i)) continue;
#endif
        ivec3 parent = listed.voxel >> 1;
        if (int(level) < frame.grid.y && listParent(level + 1u, parent, 1u << uint(listed.face)) != 0u)
            listFace(level + 1u, parent, listed.face);
#endif
    }
#ifdef VCT_PART
    emptyMoving(level + 2u);
#endif
}
