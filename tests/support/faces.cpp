#include "support/faces.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vct::test {

namespace {

// Where shaders/directional/voxels.glsl puts a face.
glm::ivec3 texelOf(const glm::ivec3& voxel, int face, int side) {
    return voxel + glm::ivec3(face / 2 * side, face % 2 * side, 0);
}

// One level's texels in the texture's order, x fastest.
class Atlas {
  public:
    explicit Atlas(int side)
        : side_(side),
          width_(3 * side),
          height_(2 * side),
          texels_(static_cast<std::size_t>(width_) * height_ * side) {}
    int width() const { return width_; }
    int height() const { return height_; }
    glm::u8vec4* slice(int z) { return &texels_[static_cast<std::size_t>(z) * width_ * height_]; }
    glm::u8vec4& at(const glm::ivec3& voxel, int face) {
        const glm::ivec3 p = texelOf(voxel, face, side_);
        return slice(p.z)[static_cast<std::size_t>(p.y) * width_ + p.x];
    }

  private:
    int side_, width_, height_;
    std::vector<glm::u8vec4> texels_;
};

FaceLevel readLevel(const gl::Texture& faces, int level, int side) {
    const gl::Framebuffer framebuffer("read back faces", 1, 1);
    framebuffer.bind();
    gl::ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl::MemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
    gl::PixelStorei(GL_PACK_ALIGNMENT, 4);
    Atlas atlas(side);
    for (int z = 0; z < side; ++z) {
        gl::FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, faces.name(), level, z);
        gl::ReadPixels(0, 0, atlas.width(), atlas.height(), GL_RGBA, GL_UNSIGNED_BYTE, atlas.slice(z));
    }
    FaceLevel result(side);
    result.forEachVoxel([&](const glm::ivec3& voxel) {
        for (int face = 0; face < faceCount; ++face)
            result.at(voxel, face) = atlas.at(voxel, face);
    });
    return result;
}

void writeLevel(const gl::Texture& faces, int level, const FaceLevel& values) {
    Atlas atlas(values.side());
    values.forEachVoxel([&](const glm::ivec3& voxel) {
        for (int face = 0; face < faceCount; ++face)
            atlas.at(voxel, face) = values.at(voxel, face);
    });
    faces.bind(VCT_TEX_FACES);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl::TexSubImage3D(GL_TEXTURE_3D, level, 0, 0, 0, atlas.width(), atlas.height(), values.side(), GL_RGBA,
                      GL_UNSIGNED_BYTE, atlas.slice(0));
}

}  // namespace

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

int largestDifference(const FaceLevel& a, const FaceLevel& b) {
    int largest = 0;
    a.forEachVoxel([&](const glm::ivec3& voxel) {
        for (int face = 0; face < faceCount; ++face)
            for (int c = 0; c < 4; ++c)
                largest = std::max(largest, std::abs(int{a.at(voxel, face)[c]} - int{b.at(voxel, face)[c]}));
    });
    return largest;
}

FaceLevel readFaceLevel(const DirectionalVoxels& voxels, int level) {
    return readLevel(voxels.faces(), level, voxels.grid() >> level);
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
            const int front = face % 2 == 0 ? 1 : 0;  // the child that the face looks out of
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

void writeFacePyramid(const DirectionalVoxels& voxels, FaceLevel base) {
    for (int level = 0; level < voxels.levels(); ++level) {
        writeLevel(voxels.faces(), level, base);
        if (level + 1 < voxels.levels()) base = faceMipOnCpu(base);
    }
}

}  // namespace vct::test
