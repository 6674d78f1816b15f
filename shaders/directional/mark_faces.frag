// First of two passes over the triangles: marks the occupied faces of each voxel that has none with ids. The
// first fragment of a voxel appends it to the list.
#include "shared/commands.glsl"
#include "directional/coverage.glsl"

layout(r32ui, binding = VCT_IMAGE_VOXELS) coherent uniform uimage3D index;
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
        if (isKept(part.voxel) || imageLoad(index, voxel).r > VCT_FACE_MASK) continue;
#endif
        if (faces != 0u && imageAtomicOr(index, voxel, faces) == 0u) appendVoxel(list, uvec3(voxel));
    }
}
