// The indices of occupied voxels: packCell() of each voxel, or 0. That of the static geometry has a texel per
// voxel of one cube, and the pages of directional/blocks.glsl in cascades. Those of dynamic objects, one for
// each of two poses, have pages of 4^3 texels for the blocks of voxels with faces, and a texture with a texel
// per block: the first texel of its page. The first page is empty, and is that of all blocks without faces.
#include "directional/face_data.glsl"

#if VCT_CASCADES == 1
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
#endif
layout(binding = VCT_TEX_DYNAMIC_VOXELS) uniform highp usampler3D dynamicIndex;
layout(binding = VCT_TEX_DYNAMIC_PAGES) uniform highp usampler3D dynamicPages;

// The cell of a voxel in an index of dynamic objects.
uint cellInPages(highp usampler3D index, highp usampler3D pages, ivec3 voxel) {
    ivec3 page = ivec3(texelFetch(pages, voxel >> VCT_BRICK_LEVEL, 0).xyz);
    return texelFetch(index, page + (voxel & (VCT_BRICK_SIDE - 1)), 0).r;
}
uint staticCellAt(ivec3 voxel) {
#if VCT_CASCADES == 1
    return texelFetch(staticIndex, voxel, 0).r;
#else
    uint page = faceData[pageAt(numberOfBlock(voxel >> VCT_BRICK_LEVEL))];
    return page == 0u ? 0u : faceData[page + bitInBlock(voxel)];
#endif
}
uint dynamicCellAt(ivec3 voxel) {
    return frame.hasDynamicObjects != 0 ? cellInPages(dynamicIndex, dynamicPages, voxel) : 0u;
}
