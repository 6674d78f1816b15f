// First of two passes over the triangles: marks the occupied faces of each voxel that has none with ids, and
// the blocks of these voxels.
#include "directional/block_lists.glsl"
#include "directional/coverage.glsl"
#include "directional/index.glsl"

layout(location = VCT_UNIFORM_LIST) uniform uint list;

void main() {
    Samples samples = fragmentSamples();
    if (materialHasHoles && materialIsHole(materialBaseColor().a)) discard;
    while (samples.left != 0u) {
        Part part = nextPart(samples);
        uint faces = coveredFaces(part.coverage);
        if (materialIsDoubleSided) faces |= coveredFaces(-part.coverage);
        ivec3 voxel = listedVoxel(part.voxel);
#if VCT_CASCADES > 1
        if (isKept(part.voxel) || list == 0u && staticCellAt(voxel) != 0u) continue;
#endif
        if (markInBlock(voxel, faces, list != 0u)) markBlock(voxel >> VCT_BRICK_LEVEL, list != 0u);
    }
}
