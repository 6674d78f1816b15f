// Writes the surface and the material of each base-level face from its sums, after a pose has been voxelized.
// A face that static and dynamic geometry share has two ids: at the static one are both together, and at the
// dynamic one is the static geometry alone, for rays whose hits are kept while objects move. In a scene with
// cascades in which nothing moves, it visits the faces that have no light yet; the others stay as they are.
#include "directional/visited.glsl"
#include "directional/face_sums.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_DYNAMIC_VOXELS) uniform highp usampler3D dynamicIndex;

// Points of a plane in the voxel, on a grid of 4 x 4 across the face; a bit for each.
const int side = 4;
vec2 pointAcross(int i) {
    return (vec2(i % side, i / side) + 0.5) / float(side) - 0.5;
}

float coverageOf(uint points) {
    return float(bitCount(points)) / float(side * side);
}

// The points of a plane that are inside of the voxel.
uint pointsInside(SurfacePlane plane, int axis) {
    uint points = 0u;
    for (int i = 0; i < side * side; ++i) {
        vec2 place = pointAcross(i);
        float along = (plane.offset - dot(acrossFaces(plane.normal, axis), place)) / plane.normal[axis];
        if (abs(along) <= 0.5) points |= 1u << uint(i);
    }
    return points;
}
// The points of a set that are in front of another plane.
uint pointsInFront(SurfacePlane plane, int axis, uint points, SurfacePlane other) {
    uint inFront = 0u;
    for (uint left = points; left != 0u; left &= left - 1u) {
        int i = findLSB(left);
        if (dot(pointOnPlane(plane, axis, pointAcross(i)), other.normal) > other.offset)
            inFront |= 1u << uint(i);
    }
    return inFront;
}

// The face of a voxel that a surface mostly looks towards.
int mainFace(vec3 normal) {
    vec3 size = abs(normal);
    int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + int(normal[axis] < 0.0);
}

// The normal of the fragment nearest to the middle of a face's voxel.
vec3 nearestNormal(uint staticCell, uint dynamicCell, int face) {
    uint plane = 0u;
    if (hasFace(staticCell, face)) plane = faceSumData[sumsAt(faceId(staticCell, face)) + VCT_FACE_PLANE];
    if (hasFace(dynamicCell, face))
        plane = max(plane, faceSumData[sumsAt(faceId(dynamicCell, face)) + VCT_FACE_PLANE]);
    return unpackPlane(plane).normal;
}

// If a thin wall crosses a surface, as one that stands on a floor, the face is of the larger part. But if one
// side of the wall looks the way of the face, this side may have the same face, so the face is of the part on
// that side. `points`: of the surface.
void splitByWall(uint staticCell, uint dynamicCell, int own, SurfacePlane plane, uint points,
                 inout FaceExtent extent) {
    uint others = (staticCell | dynamicCell) & VCT_FACE_MASK & ~(1u << uint(own));
    if (bitCount(others) < 2) return;
    int axis = own >> 1;
    for (uint left = others; left != 0u; left &= left - 1u) {
        int front = findLSB(left);
        vec3 normal = nearestNormal(staticCell, dynamicCell, front);
        if (abs(dot(normal, plane.normal)) > 0.7) continue;
        for (uint next = left & left - 1u; next != 0u; next &= next - 1u) {
            int back = findLSB(next);
            if (dot(normal, nearestNormal(staticCell, dynamicCell, back)) > -0.9) continue;
            SurfacePlane one = unpackPlane(visiblePlane(combinedSums(staticCell, dynamicCell, front), front));
            SurfacePlane two = unpackPlane(visiblePlane(combinedSums(staticCell, dynamicCell, back), back));
            float thickness = one.offset + two.offset;
            if (dot(one.normal, two.normal) > -0.97 || thickness < -0.05 || thickness > 1.0) continue;
            uint before = pointsInFront(plane, axis, points, one),
                 behind = pointsInFront(plane, axis, points, two);
            // A surface that ends at the wall has no part on its other side.
            bool ends = ((extent.inFront | extent.behind) & (1u << uint(front) | 1u << uint(back))) != 0u;
            if (ends || before == 0u || behind == 0u) continue;
            const float perpendicular = 0.15;
            float lean = (own & 1) == 0 ? one.normal[axis] : -one.normal[axis];
            bool isBefore = abs(lean) > perpendicular ? lean > 0.0 : bitCount(before) >= bitCount(behind);
            uint mine = isBefore ? before : behind, bit = 1u << uint(isBefore ? front : back);
            extent.inFront |= bit;
            extent.behind |= bit;
            vec2 sum = vec2(0.0);
            for (uint rest = mine; rest != 0u; rest &= rest - 1u)
                sum += pointAcross(findLSB(rest));
            extent.place = sum / float(bitCount(mine));
            return;
        }
    }
}

void main() {
    uint count = visitedFaceCount();
    bool hasDynamic = faceCount(dynamicList) > 0u;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        bool isStatic = id < commands[0].faceCapacity;
        if (listed.isMerged && isStatic) continue;  // no face has the id
        int axis = listed.face >> 1;
        uint staticCell = texelFetch(staticIndex, listed.voxel, 0).r;
        uint dynamicCell = hasDynamic ? texelFetch(dynamicIndex, listed.voxel, 0).r : 0u;
        if (listed.isMerged || !hasFace(dynamicCell, listed.face)) dynamicCell = 0u;
        FaceSums sums = combinedSums(staticCell, dynamicCell, listed.face);
        uint visible = visiblePlane(sums, listed.face);
        SurfacePlane plane = unpackPlane(visible);
        float coverage = min(sums.coverage, 1.0), weight = max(sums.coverage, 1e-4);
        vec2 place = sums.place / weight - 0.5;
        vec3 middle = pointOnPlane(plane, axis, place);
        // Coverage has steps of 1/16. They are exact where the surface looks along the axis.
        float step = abs(plane.normal[axis]) > 0.99 ? 0.06 : 0.09;
        uint points = pointsInside(plane, axis);
        float planeCoverage = coverageOf(points);
        FaceExtent extent = FaceExtent(coverage, isCurved(visible), place, 0u, 0u);
        if (coverage < planeCoverage - min(step, 0.1)) {
            // The surface ends in the voxel: at other surfaces, or else as its middle tells.
            uint cells = staticCell | dynamicCell;
            for (uint left = cells & VCT_FACE_MASK; left != 0u; left &= left - 1u) {
                int face = findLSB(left);
                if (face == listed.face) continue;
                FaceSums otherSums = combinedSums(staticCell, dynamicCell, face);
                SurfacePlane other = unpackPlane(visiblePlane(otherSums, face));
                if (abs(dot(plane.normal, other.normal)) > 0.9) continue;
                bool isInFront = dot(middle, other.normal) > other.offset;
                // A surface ends at that one of a thin wall's two planes which it makes an edge with: each is
                // in front of the other, or each is behind it. The inside of a box does not end its outside.
                if (hasFace(cells, face ^ 1)) {
                    vec2 otherPlace = otherSums.place / max(otherSums.coverage, 1e-4) - 0.5;
                    vec3 otherMiddle = pointOnPlane(other, face >> 1, otherPlace);
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
        if (ends) step = 0.12;
        float opacity = 1.0;
        if (coverage < planeCoverage - step) {
            float covered = ends
                                ? planeCoverage
                                : min(planeCoverage, (1.0 - 2.0 * abs(place.x)) * (1.0 - 2.0 * abs(place.y)));
            // Less than 1, so that rays test the rectangle (covers() in ray.glsl).
            opacity = coverage >= covered - step ? 0.996 : coverage / max(covered, 0.05);
        }
        // A surface that looks past its face is met at the face that it looks towards. There what it covers
        // is known better: on a round column of one voxel, such faces would make it half as wide again. The
        // two faces of a flat surface have the same plane. Those of a round one have not, but look alike.
        int most = mainFace(plane.normal);
        if (abs(plane.normal[axis]) < 0.3 && hasFace(staticCell | dynamicCell, most)) {
            uint mostVisible = visiblePlane(combinedSums(staticCell, dynamicCell, most), most);
            SurfacePlane other = unpackPlane(mostVisible);
            bool isRound = isCurved(visible) && isCurved(mostVisible);
            if (dot(plane.normal, other.normal) > (isRound ? 0.8 : 0.97) &&
                (isRound || abs(plane.offset - other.offset) < 0.05)) {
                opacity = 0.0;
                extent.inFront = extent.behind = 0u;
            }
        }
        splitByWall(staticCell, dynamicCell, listed.face, plane, points, extent);
        uint at = faceAt(id);
        faceData[at + VCT_FACE_SURFACE] = packSurface(visible, opacity);
        faceData[at + VCT_FACE_EXTENT] = packExtent(extent);
        faceData[at + VCT_FACE_REFLECTANCE] = packRgb9e5(visibleAlbedo(sums));
#ifdef VCT_EMISSION
        // Emissions of several layers are added, because a lamp directly below a ceiling hides the ceiling
        // and must not be darkened by its layer.
        float layer = hasLayers(sums) ? coverage : weight;
        faceData[at + VCT_FACE_EMITTED] = packRgb9e5(sums.emission / layer);
#endif
    }
}
