// What the bounces pass on: the light that each occupied voxel of level 1 (a block of 2 x 2 x 2) receives per face.
layout(std430, binding = VCT_SSBO_FACE_LIGHT) buffer FaceLightBlock {
    uvec2 faceLight[];  // per block in the list of level 1, per face: three halves, relative to E/pi, before albedo
};

uint faceLightBlocks() {
    return uint(faceLight.length()) / 6u;
}
