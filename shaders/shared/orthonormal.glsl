// A right-handed frame around a normal (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
// Columns: tangent, normal, bitangent.
mat3 frameAround(vec3 n) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    vec3 tangent = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    return mat3(tangent, n, cross(tangent, n));
}
