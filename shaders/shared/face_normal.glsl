// The normal of the triangle's plane, on the side of `towards`, of unit length. `position`: an interpolated
// position. Call it before any branch or discard, because derivatives need the whole quad.
vec3 faceNormal(vec3 position, vec3 towards) {
    vec3 normal = cross(dFdx(position), dFdy(position));
    normal *= inversesqrt(max(dot(normal, normal), 1e-36));
    return dot(normal, towards) < 0.0 ? -normal : normal;
}
