// Finds which faces beside each face are of the same surface and of the same side of all walls, so that the
// smoothing may take the mean over them (directional/beside_faces.glsl). It runs when an object has moved,
// for the faces near it, or, for the faces of list_arrived.comp, a cascade.
#include "directional/changed.glsl"
#include "directional/rows.glsl"
#include "directional/visited.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// A face's surface.
struct Surface {
    vec3 middle, normal;
};

// The voxel above the surface in which walls that stand on it are looked for, `paces` from the row's middle.
ivec3 voxelAbove(Row row, Surface surface, float paces) {
    const float height = 0.75;
    return ivec3(floor(row.start + height * surface.normal + paces * row.pace));
}

// True if one of the faces of a voxel is of a surface, such as a wall that stands on the face's, between the
// face and the next one of the row. `faces`: a bit for each face of the cell that may be.
bool hasWall(Row row, Surface surface, ivec3 voxel, uint cell, uint faces) {
    for (uint left = cell & faces; left != 0u; left &= left - 1u) {
        SurfacePlane plane = facePlane(faceId(cell, findLSB(left)));
        float towards = -dot(row.pace, plane.normal);
        if (towards < 0.1 || abs(dot(plane.normal, surface.normal)) > 0.7) continue;
        float above = dot(surface.middle - vec3(voxel) - 0.5, plane.normal) - plane.offset;
        if (above > 0.0 && above < towards) return true;
    }
    return false;
}

// True if the face of a voxel of the row is of the same surface, and on the same side of a thin wall that
// crosses it.
bool isOfSurface(Row row, Surface surface, ivec3 voxel, int face, uint id) {
    if (dot(facePlane(id).normal, surface.normal) < 0.5) return false;
    WallFace wall = wallAcross(faceExtent(id), voxel, face);
    if (wall.face < 0) return true;
    uint cell = cellBeside(row, wall.voxel, 1u << uint(wall.face));
    SurfacePlane plane = facePlane(faceId(cell, wall.face));
    return dot(surface.middle - vec3(wall.voxel) - 0.5, plane.normal) > plane.offset;
}

// True if the next face along a row is linked. `above`: the voxel above the face, with the cell `cellAbove`.
bool isLinked(Row row, Surface surface, int face, ivec3 above, uint cellAbove) {
    float squared = dot(row.pace, row.pace);
    // Along a steep row the next voxel of the face's axis is too far away. Between two voxels of a slanted
    // row there may be a third one.
    bool isSteep = squared > 2.1, isSlanted = squared > 1.01;
    if (isSteep) return false;
    uint own = 1u << uint(face), others = VCT_FACE_MASK & ~own;
    if (hasWall(row, surface, above, cellAbove, others)) return false;
    for (float paces = isSlanted ? 0.5 : 1.0; paces < 1.1; paces += 0.5) {
        ivec3 voxel = voxelAbove(row, surface, paces);
        if (hasWall(row, surface, voxel, cellBeside(row, voxel, others), others)) return false;
    }
    ivec3 voxel = voxelOfRow(row, 1.0);
    uint cell = cellBeside(row, voxel, own);
    return hasFace(cell, face) && isOfSurface(row, surface, voxel, face, faceId(cell, face));
}

void main() {
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged || isUnchanged(id, listed.voxel)) continue;
        SurfacePlane plane = facePlane(id);
        Surface surface =
            Surface(surfaceMiddle(listed.voxel, listed.face, plane, faceExtent(id)), plane.normal);
        Row first = rowOf(listed, plane, vec2(-1.0, 0.0)), second = rowOf(listed, plane, vec2(0.0, -1.0));
        ivec3 above = voxelAbove(first, surface, 0.0);
        uint cellAbove = cellBeside(first, above, VCT_FACE_MASK & ~(1u << uint(listed.face)));
        uint links = 0u;
        for (int side = 0; side < 4; ++side) {
            Row row = first;
            row.pace = ((side & 2) == 0 ? first.pace : second.pace) * ((side & 1) == 0 ? 1.0 : -1.0);
            if (isLinked(row, surface, listed.face, above, cellAbove)) links |= 1u << uint(side);
        }
        storeLinks(id, links);
    }
}
