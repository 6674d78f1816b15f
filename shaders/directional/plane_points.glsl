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
