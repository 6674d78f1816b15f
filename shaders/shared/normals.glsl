// Unit vectors as integers, by the octahedral map (Cigolle et al. 2014, "A Survey of Efficient
// Representations for Independent Unit Vectors"), and the normals of the G-buffer.

// 16 bits per component. The error is below 0.004 degrees.
uvec2 encodeOctahedral(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0) p = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return uvec2(round((clamp(p, -1.0, 1.0) * 0.5 + 0.5) * 65534.0));  // 65534: even, so 0 is exact
}

// `steps`: the code of +1 in both components, 65534 for encodeOctahedral().
vec3 decodeOctahedral(uvec2 code, float steps) {
    vec2 p = vec2(code) / steps * 2.0 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    vec2 folded = vec2(max(-n.z, 0.0));
    n.xy -= mix(-folded, folded, greaterThanEqual(n.xy, vec2(0.0)));
    return normalize(n);
}

// Returns a unit normal, or +Y for a zero vector, which interpolation or a degenerate triangle can give.
// Never NaN.
vec3 safeNormalize(vec3 v) {
    float squared = dot(v, v);
    return squared > 1e-20 ? v * inversesqrt(squared) : vec3(0.0, 1.0, 0.0);
}

// The G-buffer stores two unit normals in 40 bits: the interpolated normal with 12 bits per component (an
// error below 0.06 degrees), and the normal of the triangle's plane with 8 bits (below 1 degree). The sun
// reaches only triangles that are turned to it, and shadow maps show planes, while shading uses the
// interpolated normal. xy: RG16UI. z: 0 to 255, for the alpha of the albedo.
const uint normalSteps = 4094u, faceNormalSteps = 254u;  // even, so 0 is exact

uvec2 toFaceNormalSteps(uvec2 code) {
    return (code * faceNormalSteps + normalSteps / 2u) / normalSteps;
}

uvec3 encodeNormals(vec3 normal, vec3 faceNormal) {
    uvec2 code = (encodeOctahedral(normal) * normalSteps + 32767u) / 65534u;
    // If both normals are equal, decoding returns the interpolated one, which has more bits.
    const float sameCosine = 0.99999;  // 0.26 degrees
    uvec2 face = dot(normal, faceNormal) > sameCosine
                     ? toFaceNormalSteps(code)
                     : (encodeOctahedral(faceNormal) * faceNormalSteps + 32767u) / 65534u;
    return uvec3(code | (face >> 4u) << 12u, (face.x & 15u) | (face.y & 15u) << 4u);
}

// The interpolated normal.
vec3 decodeNormal(uvec2 code) {
    return decodeOctahedral(code & 4095u, float(normalSteps));
}

struct FaceNormal {
    vec3 normal;
    bool isInterpolated;  // the same as the interpolated normal
};
// `alpha`: alpha of the albedo.
FaceNormal decodeFaceNormal(uvec2 code, float alpha) {
    uint low = uint(alpha * 255.0 + 0.5);
    uvec2 face = (code >> 12u) << 4u | uvec2(low & 15u, low >> 4u);
    // Is face == toFaceNormalSteps(code & 4095u)? Floats are exact here, and cheaper than the division.
    vec2 rest = vec2(code & 4095u) * float(faceNormalSteps) - vec2(face) * float(normalSteps);
    if (all(lessThan(abs(rest + 0.5), vec2(normalSteps / 2u)))) return FaceNormal(decodeNormal(code), true);
    return FaceNormal(decodeOctahedral(face, float(faceNormalSteps)), false);
}
