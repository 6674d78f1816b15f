// A face of a mip level from those of the level below: of each of the four pairs of children along the face's axis the
// front one over the back one, and the mean of the pairs. A wall across the voxel stays opaque at every level, and is seen
// from one side only.
#include "shared/counters.glsl"
#include "directional/face_parents.glsl"
#include "directional/voxels.glsl"

layout(binding = VCT_TEX_FACES) uniform mediump sampler3D faces;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D means;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // that is written

// `which`: storedFace()'s.
void storeMean(ListedFace listed, uint which) {
    COUNT(VCT_COUNTER_FACE_MIPMAPPER_FACE);
    int childGrid = textureSize(faces, int(level) - 1).z;
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
}

// The parent of a face, and the face of it that looks the same way, into the next level's lists.
void listParentOf(ListedFace listed) {
    ivec3 parent = listed.voxel >> 1;
    if (int(level) < findMSB(frame.gridSide) && listParent(level + 1u, parent, 1u << uint(listed.face)) != 0u)
        listFace(level + 1u, parent, listed.face);
}
