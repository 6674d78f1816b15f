#include "support/faces.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vct::test {

glm::dvec3 faceDirection(int face) {
    glm::dvec3 direction(0.0);
    direction[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
    return direction;
}

const char* faceName(int face) {
    static const char* const names[faceCount] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    return names[face];
}

bool FaceLevel::occupied(const glm::ivec3& voxel) const {
    for (int face = 0; face < faceCount; ++face)
        if (at(voxel, face) != glm::u8vec4(0)) return true;
    return false;
}

int maxDifference(const FaceLevel& a, const FaceLevel& b) {
    int largest = 0;
    a.forEachVoxel([&](const glm::ivec3& voxel) {
        for (int face = 0; face < faceCount; ++face)
            for (int c = 0; c < 4; ++c)
                largest = std::max(largest, std::abs(int{a.at(voxel, face)[c]} - int{b.at(voxel, face)[c]}));
    });
    return largest;
}

FaceLevel readFaceLevel(const DirectionalVoxels& voxels, int level) {
    const gl::Framebuffer framebuffer("read back faces", 1, 1);
    framebuffer.bind();
    gl::ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl::MemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
    gl::PixelStorei(GL_PACK_ALIGNMENT, 4);
    const int side = voxels.grid() >> level;
    FaceLevel result(side, voxels.cascades());
    // shaders/directional/voxels.glsl puts three blocks of faces beside each other and two on top.
    std::vector<glm::u8vec4> slice(static_cast<std::size_t>(faceCount) * side * side);
    for (int z = 0; z < result.depth(); ++z) {
        gl::FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, voxels.faces().name(), level, z);
        gl::ReadPixels(0, 0, 3 * side, 2 * side, GL_RGBA, GL_UNSIGNED_BYTE, slice.data());
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                for (int face = 0; face < faceCount; ++face) {
                    const int row = face % 2 * side + y, column = face / 2 * side + x;
                    result.at({x, y, z}, face) = slice[static_cast<std::size_t>(row) * 3 * side + column];
                }
    }
    return result;
}

std::vector<FaceLevel> readFaces(const DirectionalVoxels& voxels) {
    std::vector<FaceLevel> levels;
    for (int level = 0; level < voxels.levels(); ++level)
        levels.push_back(readFaceLevel(voxels, level));
    return levels;
}

FaceLevel faceMipOnCpu(const FaceLevel& children) {
    FaceLevel parents(children.side() / 2);
    parents.forEachVoxel([&](const glm::ivec3& parent) {
        for (int face = 0; face < faceCount; ++face) {
            const int axis = face / 2;
            const int front = face % 2 == 0 ? 1 : 0;  // the child in front
            glm::dvec4 sum(0.0);
            for (int pair = 0; pair < 4; ++pair) {
                glm::ivec3 child = 2 * parent;
                child[(axis + 1) % 3] += pair & 1;
                child[(axis + 2) % 3] += pair >> 1;
                glm::ivec3 behind = child;
                child[axis] += front;
                behind[axis] += 1 - front;
                const glm::dvec4 f = glm::dvec4(children.at(child, face)) / 255.0;
                const glm::dvec4 b = glm::dvec4(children.at(behind, face)) / 255.0;
                sum += f + (1.0 - f.a) * b;
            }
            parents.at(parent, face) = glm::u8vec4(glm::round(sum * (255.0 / 4.0)));
        }
    });
    return parents;
}

}  // namespace vct::test
