// Computes one mip level of the faces, over the level's face list. Along the face's axis, the front one of
// two children is composited over the back one, and the face is the mean of the four pairs. A wall across the
// voxel thus stays opaque at every level, and is visible from one side only.
#include "directional/face_lists.glsl"
#include "directional/voxels.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_FACES) uniform mediump sampler3D faces;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D means;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // the level to write
layout(location = VCT_UNIFORM_FRAME_INDEX) uniform uint frameIndex;

void storeMean(ListedFace listed) {
    int childGrid = textureSize(faces, int(level) - 1).x / 3;
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
    imageStore(means, texel, ditherToUnorm8(sum * 0.25, texel, frameIndex));
}

void main() {
    COUNT(VCT_COUNTER_FACE_MIPMAPPER);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_FACE_MIPMAPPER_FACE);
        storeMean(listedFace(level, i));
    }
}
