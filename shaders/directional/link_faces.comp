// Finds which faces beside each face are of the same surface and of the same side of all walls, so that the
// smoothing may take the mean over them (directional/beside_faces.glsl). It runs when an object has moved,
// or, for the faces of list_unlinked.comp, a cascade.
#include "directional/rows.glsl"
#include "directional/visited.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// A face's surface.
struct Surface {
    vec3 middle, normal;
};

// The number of paces after which a surface, such as a wall that stands on the face's, is between the row's
// middle and what follows, as far as the faces in the voxel `t` paces away tell. `others`: a bit for each
// face but those of the row.
float paceOfWall(Row row, Surface surface, float t, uint others) {
    // Walls are looked for above the surface. Their voxels are at most so many paces away from them.
    const float height = 0.75, inVoxel = 0.9, none = 1e9;
    ivec3 voxel = ivec3(floor(row.start + height * surface.normal + t * row.pace));
    uint cell = cellBeside(row, voxel, others);
    float found = none;
    for (uint left = cell & others; left != 0u; left &= left - 1u) {
        SurfacePlane plane = facePlane(faceId(cell, findLSB(left)));
        float towards = -dot(row.pace, plane.normal);
        if (towards < 0.1 || abs(dot(plane.normal, surface.normal)) > 0.7) continue;
        float at = (dot(surface.middle - vec3(voxel) - 0.5, plane.normal) - plane.offset) / towards;
        if (at > 0.0 && abs(at - t) < inVoxel) found = min(found, at);
    }
    return found;
}

// True if a face is of the same surface, and on the same side of a thin wall that crosses it.
bool isOfSurface(Surface surface, ivec3 voxel, uint cell, uint id) {
    if (dot(facePlane(id).normal, surface.normal) < 0.5) return false;
    FaceExtent extent = faceExtent(id);
    uint walls = extent.inFront & extent.behind;
    if (walls == 0u) return true;
    SurfacePlane wall = facePlane(faceId(cell, findLSB(walls)));
    return dot(surface.middle - vec3(voxel) - 0.5, wall.normal) > wall.offset;
}

// A bit for each of the two faces that follow along a row.
uint linksAlong(Row row, Surface surface, int face) {
    float squared = dot(row.pace, row.pace);
    // Along a steep row the next voxel of the face's axis is too far away. Between two voxels of a slanted
    // row there may be a third one.
    bool isSteep = squared > 2.1, isSlanted = squared > 1.01;
    if (isSteep) return 0u;
    uint own = 1u << uint(face), others = VCT_FACE_MASK & ~own, links = 0u;
    float wall = paceOfWall(row, surface, 0.0, others);
    for (int steps = 1; steps <= 2; ++steps) {
        float t = float(steps);
        if (isSlanted) wall = min(wall, paceOfWall(row, surface, t - 0.5, others));
        wall = min(wall, paceOfWall(row, surface, t, others));
        if (wall < t) break;
        ivec3 voxel = voxelOfRow(row, t);
        uint cell = cellBeside(row, voxel, own);
        if (hasFace(cell, face) && isOfSurface(surface, voxel, cell, faceId(cell, face)))
            links |= uint(steps);
    }
    return links;
}

void main() {
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        SurfacePlane plane = facePlane(id);
        Surface surface =
            Surface(surfaceMiddle(listed.voxel, listed.face, plane, faceExtent(id)), plane.normal);
        uint links = 0u;
        for (int side = 0; side < 4; ++side) {
            Row row = rowOf(listed, plane, (side & 2) == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
            if ((side & 1) == 0) row.pace = -row.pace;
            links |= linksAlong(row, surface, listed.face) << uint(2 * side);
        }
        storeLinks(id, links);
    }
}
