// Writes which part of its plane each face's surface covers in the voxel (FaceExtent), and its opacity there,
// from what the face's sums cover and the planes of the voxel's other faces (directional/resolve.comp). Of
// other faces it reads only what it leaves as it is, so the order of the faces does not matter.
#include "directional/resolved.glsl"

// The place across the face nearest to `place` at which a plane is inside of the voxel. Other surfaces of the
// face may have moved `place`, which is the mean over all of them.
vec2 placeInside(SurfacePlane plane, int axis, vec2 place) {
    vec2 across = acrossFaces(plane.normal, axis);
    float along = (plane.offset - dot(across, place)) / plane.normal[axis];
    float beyond = along - clamp(along, -0.5, 0.5);
    vec2 inside = place + across * (beyond * plane.normal[axis] / max(dot(across, across), 1e-4));
    return clamp(inside, -0.5, 0.5);
}

// The face of a voxel that a surface mostly looks towards.
int mainFace(vec3 normal) {
    vec3 size = abs(normal);
    int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + int(normal[axis] < 0.0);
}

// The id of another face of the voxel, and its plane.
uint besideId(ResolvedFace own, int face) {
    return surfaceId(own.staticCell, own.dynamicCell, face, false);
}
SurfacePlane planeOf(ResolvedFace own, int face) {
    return facePlane(besideId(own, face));
}

// The part of a voxel's cross-section that a face's surface covers, as its sums have it: the coverage, at
// most 1, and the middle of the part across the face, from the voxel's middle.
struct Covered {
    float coverage;
    vec2 place;
};
Covered coveredPart(ResolvedFace own, int face, SurfacePlane plane) {
    vec3 sum = vec3(0.0);
    if (hasFace(own.staticCell, face)) {
        // In a pose, what the static geometry covers is at the dynamic id, if they share the face.
        uint id = surfaceId(own.staticCell, own.dynamicCell, face, true);
        FaceExtent kept = faceExtent(id);
        sum = list == dynamicList ? kept.coverage * vec3(1.0, kept.place + 0.5) : coverageAndPlace(id);
    }
    if (hasFace(own.dynamicCell, face)) sum += coverageAndPlace(faceId(own.dynamicCell, face));
    vec2 place = sum.yz / max(sum.x, 1e-4) - 0.5;
    return Covered(min(sum.x, 1.0), placeInside(plane, face >> 1, place));
}

// The face of a thin wall behind which a surface goes on, and the points of the surface in front of it.
struct WallSide {
    int face;  // -1: there is no wall
    uint points;
};

// If a thin wall crosses a surface, as one that stands on a floor, the surface's face is of the larger part.
// One side of the wall may look the way of the face and have the same face, so the face is of the part on
// that side, if there is one. `at`: the voxel with the wall, which is the surface's or the one in front.
// `points`: of the surface. `but`: a bit per face that is not of a wall.
WallSide wallSide(ResolvedFace own, ResolvedFace at, SurfacePlane plane, uint points, uint but) {
    int axis = own.face >> 1;
    plane.offset += dot(plane.normal, vec3(own.voxel - at.voxel));
    uint others = facesBeside(at) & ~but;
    for (uint left = others; left != 0u; left &= left - 1u) {
        int front = findLSB(left);
        SurfacePlane one = planeOf(at, front);
        if (abs(dot(one.normal, plane.normal)) > 0.7) continue;
        for (uint next = left & left - 1u; next != 0u; next &= next - 1u) {
            int back = findLSB(next);
            SurfacePlane two = planeOf(at, back);
            float thickness = one.offset + two.offset;
            if (dot(one.normal, two.normal) > -0.97 || thickness < -0.05 || thickness > 1.0) continue;
            uint before = pointsInFront(plane, axis, points, one),
                 behind = pointsInFront(plane, axis, points, two);
            const float perpendicular = 0.15;
            float lean = (own.face & 1) == 0 ? one.normal[axis] : -one.normal[axis];
            bool isBefore = abs(lean) > perpendicular ? lean > 0.0 : bitCount(before) >= bitCount(behind);
            if ((isBefore ? before : behind) == 0u) isBefore = !isBefore;
            WallSide side = isBefore ? WallSide(front, before) : WallSide(back, behind);
            if (side.points != 0u) return side;
        }
    }
    return WallSide(-1, 0u);
}

// Gives a face to one side of a thin wall that crosses its surface. Where the surface is near the voxel in
// front, so little of the wall may be in its own voxel that no fragment is.
void splitByWall(ResolvedFace own, SurfacePlane plane, uint points, inout FaceExtent extent) {
    const float near = 0.25;
    int axis = own.face >> 1;
    uint ownBit = 1u << uint(own.face), bits = 0u;
    // A surface that ends at the wall has no part on its other side.
    WallSide wall = wallSide(own, own, plane, points, ownBit | extent.inFront | extent.behind);
    float outwards = (own.face & 1) == 0 ? plane.normal[axis] : -plane.normal[axis];
    if (wall.face < 0 && outwards > 0.7 && 0.5 - plane.offset / outwards < near) {
        ivec3 voxel = voxelInFront(own.voxel, own.face);
        if (voxel != clampToCascade(voxel, own.voxel, frame.gridSide)) return;
        wall = wallSide(own, inVoxel(own, voxel), plane, points, ownBit);
        bits = ownBit;
    }
    if (wall.face < 0) return;
    bits |= 1u << uint(wall.face);
    extent.inFront |= bits;
    extent.behind |= bits;
    vec2 sum = vec2(0.0);
    for (uint rest = wall.points; rest != 0u; rest &= rest - 1u)
        sum += pointAcross(findLSB(rest));
    extent.place = sum / float(bitCount(wall.points));
}

void main() {
    uint count = faceCount(list), stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ResolvedFace own = resolvedFace(i);
        if (!own.changes) continue;
        uint id = own.id, at = faceAt(id);
        int axis = own.face >> 1;
        SurfacePlane plane = facePlane(id);
        Covered part = coveredPart(own, own.face, plane);
        FaceExtent extent = FaceExtent(part.coverage, faceExtent(id).isCurved, part.place, 0u, 0u);
        vec3 middle = pointOnPlane(plane, axis, part.place);
        // Coverage has steps of 1/16. They are exact where the surface looks along the axis.
        float step = abs(plane.normal[axis]) > 0.99 ? 0.06 : 0.09;
        uint points = pointsInside(plane, axis);
        float planeCoverage = coverageOf(points);
        if (part.coverage < planeCoverage - step) {
            // The surface ends in the voxel: at other surfaces, or else as its middle tells.
            uint cells = facesBeside(own);
            for (uint left = cells; left != 0u; left &= left - 1u) {
                int face = findLSB(left);
                if (face == own.face) continue;
                SurfacePlane other = planeOf(own, face);
                if (abs(dot(plane.normal, other.normal)) > 0.9) continue;
                bool isInFront = dot(middle, other.normal) > other.offset;
                // A surface ends at that one of a thin wall's two planes which it makes an edge with: each is
                // in front of the other, or each is behind it. The inside of a box does not end its outside.
                if (hasFace(cells, face ^ 1)) {
                    vec3 otherMiddle = pointOnPlane(other, face >> 1, coveredPart(own, face, other).place);
                    if (isInFront != (dot(otherMiddle, plane.normal) > plane.offset)) continue;
                }
                uint inFront = pointsInFront(plane, axis, points, other);
                uint rest = isInFront ? inFront : points & ~inFront;
                if (rest == points) continue;
                if (isInFront)
                    extent.inFront |= 1u << uint(face);
                else
                    extent.behind |= 1u << uint(face);
                points = rest;
            }
            planeCoverage = coverageOf(points);
        }
        bool ends = (extent.inFront | extent.behind) != 0u;
        if (ends) step = 0.19;  // the points and the samples have steps of 1/8 and 1/16
        float opacity = 1.0;
        if (part.coverage < planeCoverage - step) {
            float covered =
                ends ? planeCoverage
                     : min(planeCoverage, (1.0 - 2.0 * abs(part.place.x)) * (1.0 - 2.0 * abs(part.place.y)));
            opacity = part.coverage >= covered - step ? float(opaqueInPart) / 255.0
                                                      : part.coverage / max(covered, 0.05);
        }
        // A sliver of a round surface: with what rays add beyond its edges (acrossPlane), it would make a
        // column wider than it is.
        const float sliver = 0.14;
        if (extent.isCurved && part.coverage < sliver) opacity = 0.0;
        // A surface that looks past its face is met at the face that it looks towards. There what it covers
        // is known better: on a round column of one voxel, such faces would make it half as wide again. The
        // two faces of a flat surface have the same plane. Those of a round one have not, but look alike.
        int most = mainFace(plane.normal);
        if (abs(plane.normal[axis]) < 0.3 && hasFace(facesBeside(own), most)) {
            uint mostId = besideId(own, most);
            SurfacePlane other = facePlane(mostId);
            bool isRound = extent.isCurved && faceExtent(mostId).isCurved;
            if (dot(plane.normal, other.normal) > (isRound ? 0.8 : 0.97) &&
                (isRound || abs(plane.offset - other.offset) < 0.05)) {
                opacity = 0.0;
                extent.inFront = extent.behind = 0u;
            }
        }
        splitByWall(own, plane, points, extent);
        faceData[at + VCT_FACE_SURFACE] = packSurface(faceData[at + VCT_FACE_SURFACE], opacity);
        faceData[at + VCT_FACE_EXTENT] = packExtent(extent);
    }
}
