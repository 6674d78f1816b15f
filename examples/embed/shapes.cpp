#include "shapes.h"

#include <cmath>

constexpr float pi = 3.14159265F;

Shape box(Vector halfSize, bool inside) {
    Shape shape;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0F, 1.0F}) {
            if (inside && axis == 2 && side > 0.0F) continue;
            const auto first = static_cast<std::uint32_t>(shape.positions.size() / 3);
            for (const Vector corner : {Vector{-1, -1}, Vector{1, -1}, Vector{1, 1}, Vector{-1, 1}})
                for (std::size_t i = 0; i < 3; ++i) {
                    const float along = i == axis ? side : corner[(i + 2 - axis) % 3];
                    shape.positions.push_back(along * halfSize[i]);
                    shape.normals.push_back(i == axis ? (inside ? -side : side) : 0.0F);
                }
            const bool flipped = (side < 0.0F) != inside;
            for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U})
                shape.indices.push_back(first + (flipped ? 3U - i : i));
        }
    return shape;
}

Shape ball(float radius) {
    constexpr std::uint32_t rings = 16, sectors = 32;
    Shape shape;
    for (std::uint32_t ring = 0; ring <= rings; ++ring)
        for (std::uint32_t sector = 0; sector <= sectors; ++sector) {
            const float down = pi * static_cast<float>(ring) / rings;
            const float around = 2.0F * pi * static_cast<float>(sector) / sectors;
            for (const float n :
                 {std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around)}) {
                shape.normals.push_back(n);
                shape.positions.push_back(radius * n);
            }
            if (ring == rings || sector == sectors) continue;
            const std::uint32_t here = ring * (sectors + 1) + sector, below = here + sectors + 1;
            for (const std::uint32_t index : {here, below, below + 1, here, below + 1, here + 1})
                shape.indices.push_back(index);
        }
    return shape;
}

Matrix4 translation(Vector by) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, by[0], by[1], by[2], 1};
}

Matrix4 rotationAboutX(float degrees) {
    const float c = std::cos(degrees * pi / 180.0F), s = std::sin(degrees * pi / 180.0F);
    return {1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1};
}

Matrix4 perspective(float verticalDegrees, float aspect, float near, float far) {
    const float f = 1.0F / std::tan(verticalDegrees * pi / 360.0F);
    return {f / aspect,
            0,
            0,
            0,
            0,
            f,
            0,
            0,
            0,
            0,
            (far + near) / (near - far),
            -1,
            0,
            0,
            2 * far * near / (near - far),
            0};
}

Matrix4 product(const Matrix4& a, const Matrix4& b) {
    Matrix4 result{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t i = 0; i < 4; ++i)
                result[4 * column + row] += a[4 * i + row] * b[4 * column + i];
    return result;
}
