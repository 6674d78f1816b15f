// Finds where the cones of a face start, and the surface that closes in on it there.
//
// A cone starts VCT_GATHER_START above its surface. Near a contact or a crease that point can lie behind
// another surface. Faces are seen from their front only, so the cone would look out through the other's back
// and bring light into the contact. The planes of the faces in the voxels around the start show where that
// is so. Lengths are in voxels. The including shader defines VCT_COUNTER_CONTACT_VOXEL and
// VCT_COUNTER_CONTACT_FACE.
#include "directional/face_sums.glsl"
#include "directional/cascades.glsl"

layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_DYNAMIC_VOXELS) uniform highp usampler3D dynamicIndex;

struct ConeStart {
    vec3 position;
    // The nearest surface that faces this one: its normal (0 if there is none), a point of its plane, and its
    // voxel and face.
    vec3 opposite;
    vec3 oppositePoint;
    ivec3 voxel;
    int face;
};

// The id of a voxel's face. Returns false if no surface covers it.
bool findFace(uint staticCell, uint dynamicCell, int face, out uint id) {
    return findStaticFace(staticCell, face, id) || findDynamicFace(dynamicCell, face, id);
}

// Returns where the cones of the face `ownFace` start. `plane`: the plane of its surface.
ConeStart coneStartOf(ivec3 voxel, int ownFace, SurfacePlane plane) {
    // A surface that faces this one is either in front of it or, in a sheet, at the same place or behind it.
    const float sheet = 0.04;  // the planes are rounded
    // Cones start low in the gap below an opposite surface, because they see less of the outside from higher
    // up.
    const float shareOfGap = 0.15;
    // In a crease, the start is at least this far in front of the other wall.
    const float fromWall = 0.3;
    vec3 surface = vec3(voxel) + 0.5 + plane.normal * plane.offset;
    float height = VCT_GATHER_START;
    vec3 aside = vec3(0.0);
    ConeStart start = ConeStart(surface, vec3(0.0), vec3(0.0), voxel, 0);
    ivec3 above = clampToCascade(ivec3(floor(surface + plane.normal * height)), voxel, frame.gridSide);
    bool hasDynamic = faceCount(dynamicList) > 0u;
    for (int i = 0; i < (above == voxel ? 1 : 2); ++i) {
        COUNT(VCT_COUNTER_CONTACT_VOXEL);
        ivec3 around = i == 0 ? voxel : above;
        uint staticCell = texelFetch(staticIndex, around, 0).r;
        uint dynamicCell = hasDynamic ? texelFetch(dynamicIndex, around, 0).r : 0u;
        for (uint left = (staticCell | dynamicCell) & VCT_FACE_MASK; left != 0u; left &= left - 1u) {
            COUNT(VCT_COUNTER_CONTACT_FACE);
            int face = findLSB(left);
            uint id;
            if (i == 0 && face == ownFace || !findFace(staticCell, dynamicCell, face, id)) continue;
            FaceSurface other = faceSurface(id);
            vec3 normal = other.plane.normal, point = vec3(around) + 0.5 + normal * other.plane.offset;
            float cosine = dot(normal, plane.normal), inFront = dot(surface - point, normal);
            if (cosine < -0.3) {
                float gap = inFront / -cosine;
                if (inFront < sheet || shareOfGap * gap > height) continue;
                height = shareOfGap * gap;
                start = ConeStart(surface, normal, point, around, face);
            } else if (cosine < 0.5 && !other.hasBack) {
                aside += (normal - plane.normal * cosine) * max(fromWall - inFront, 0.0);
            }
        }
    }
    start.position = surface + plane.normal * height + aside;
    return start;
}

// The distance at which a ray leaves the voxel of the opposite surface.
float distanceOutOfVoxel(ConeStart start, vec3 direction) {
    vec3 away = (vec3(start.voxel) + step(0.0, direction) - start.position) / direction;
    return min(away.x, min(away.y, away.z));
}

// The distance at which a ray from the start meets the opposite surface within its voxel, or -1.
float distanceToOpposite(ConeStart start, vec3 direction) {
    float towards = -dot(direction, start.opposite);
    if (towards <= 0.0) return -1.0;
    float distance = dot(start.position - start.oppositePoint, start.opposite) / towards;
    vec3 aside = abs(start.position + distance * direction - vec3(start.voxel) - 0.5);
    return max(aside.x, max(aside.y, aside.z)) < 0.5 ? max(distance, 0.0) : -1.0;
}
