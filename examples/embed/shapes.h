// Triangles of a box and a ball, and the matrices that the examples need (column-major).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

using Matrix4 = std::array<float, 16>;
using Vector = std::array<float, 3>;

struct Shape {
    std::vector<float> positions, normals;
    std::vector<std::uint32_t> indices;
};

// A box. With `inside`, its faces are visible from inside and the side towards +Z is open, as a room.
Shape box(Vector halfSize, bool inside);
Shape ball(float radius);

Matrix4 translation(Vector by);
Matrix4 rotationAboutX(float degrees);
Matrix4 perspective(float verticalDegrees, float aspect, float near, float far);
Matrix4 product(const Matrix4& a, const Matrix4& b);
