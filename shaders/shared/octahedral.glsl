// Unit vectors in two 16-bit integers (Cigolle et al. 2014, "A Survey of Efficient Representations for
// Independent Unit Vectors"): 32 bits, error below 0.004 degrees, and RG16UI is colour-renderable everywhere.
uvec2 encodeNormal(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0) p = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return uvec2(round((clamp(p, -1.0, 1.0) * 0.5 + 0.5) * 65534.0));  // 65534: even, so 0 is exact
}

vec3 decodeNormal(uvec2 code) {
    vec2 p = vec2(code) / 65534.0 * 2.0 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
    return normalize(n);
}

// Returns a unit normal, or +Y for a zero vector, which interpolation or a degenerate triangle can give.
// Never NaN.
vec3 safeNormalize(vec3 v) {
    float squared = dot(v, v);
    return squared > 1e-20 ? v * inversesqrt(squared) : vec3(0.0, 1.0, 0.0);
}
