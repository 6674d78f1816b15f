// The faces of directional voxels on the CPU.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "engine/directional/directional_voxels.h"

namespace vct::test {

// A direction along an axis: 0..5 for +x, -x, +y, -y, +z, -z.
constexpr int faceCount = 6;
glm::dvec3 faceDirection(int face);
const char* faceName(int face);

// One level. rgb: premultiplied radiance relative to DirectionalVoxels::range(), a: coverage.
class FaceLevel {
  public:
    // `cascades`: cubes of side^3 voxels, one behind the other along z.
    explicit FaceLevel(int side, int cascades = 1)
        : side_(side),
          depth_(side * cascades),
          texels_(static_cast<std::size_t>(faceCount) * side * side * depth_, glm::u8vec4(0)) {}

    int side() const { return side_; }    // in voxels
    int depth() const { return depth_; }  // along z
    glm::u8vec4& at(const glm::ivec3& voxel, int face) { return texels_[index(voxel, face)]; }
    const glm::u8vec4& at(const glm::ivec3& voxel, int face) const { return texels_[index(voxel, face)]; }
    // Some face of the voxel is not zero.
    bool occupied(const glm::ivec3& voxel) const;
    bool operator==(const FaceLevel& other) const { return texels_ == other.texels_; }

    // Calls visit(voxel) for every voxel.
    template <class Visit>
    void forEachVoxel(const Visit& visit) const {
        for (int z = 0; z < depth_; ++z)
            for (int y = 0; y < side_; ++y)
                for (int x = 0; x < side_; ++x)
                    visit(glm::ivec3(x, y, z));
    }

  private:
    std::size_t index(const glm::ivec3& voxel, int face) const {
        return ((static_cast<std::size_t>(voxel.z) * side_ + voxel.y) * side_ + voxel.x) * faceCount + face;
    }
    int side_, depth_;
    std::vector<glm::u8vec4> texels_;
};

// The largest difference between two levels of one size, in 1/255.
int maxDifference(const FaceLevel& a, const FaceLevel& b);

FaceLevel readFaceLevel(const DirectionalVoxels& voxels, int level);
// Every level, the finest first.
std::vector<FaceLevel> readFaces(const DirectionalVoxels& voxels);

// The next level. A face is the mean of four pairs of children along its axis, the front one over the back
// one: F + (1 - alpha of F) B, rounded to nearest.
FaceLevel faceMipOnCpu(const FaceLevel& children);

}  // namespace vct::test
