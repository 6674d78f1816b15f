// Directional voxels: six one-sided faces per voxel, filterable, with mip levels, and the lists of what is
// not empty. The static geometry and the dynamic objects have separate sums, which the injection of light
// combines. shaders/directional/voxels.glsl, face_lists.glsl and face_sums.glsl say what each part holds.
#pragma once

#include <array>
#include <optional>

#include "engine/voxel_pyramid.h"
#include "scene/scene.h"

namespace vct {

// The fixed-point units of a whole face in the sums of voxelization: 4096, or fewer where a scene has so many
// triangles that a sum could overflow otherwise. (A triangle makes one fragment in a voxel at most.)
float faceSumUnits(std::size_t triangles);

gl::ProgramDescription clearDynamicProgram(bool emission);
gl::ProgramDescription clearLevelProgram();
gl::ProgramDescription resetListsProgram();

// Capacities of the lists of faces, by list (VCT_LISTS).
using FaceCapacities = std::array<std::uint32_t, VCT_LISTS>;

class DirectionalVoxels {
  public:
    // `listCapacity`: of the base level's list of voxels, as for VoxelPyramid. `dynamicObjects`: the scene
    // has some. `emission`: faces have sums of the light that surfaces emit.
    DirectionalVoxels(const gl::ShaderLibrary& shaders, int grid, std::uint32_t listCapacity,
                      bool dynamicObjects, bool emission);

    Resources resources() const;
    static std::size_t bytesFor(int grid, std::uint32_t listCapacity);
    // The faces' texture holds six blocks of grid^3 texels, so many along x and y.
    static constexpr int blocksX = 3, blocksY = 2;

    int grid() const { return index_.grid(); }
    int levels() const { return faces_.levels(); }

    // RGBA8, 3 x 2 blocks of grid^3, sampled trilinearly. Radiance is relative to range().
    const gl::Texture& faces() const { return faces_; }
    // A shared::FaceRange, for shaders/directional/face_range.glsl: it stays on the GPU.
    const gl::Buffer& range() const { return range_; }
    // The occupied voxels of the static geometry, and the lists of everything.
    const VoxelPyramid& index() const { return index_; }
    // The words of all faces, and the lists of faces.
    const gl::Buffer& faceData() const { return faceData_; }
    // Words of each face.
    std::uint32_t faceWords() const { return emission_ ? VCT_EMISSIVE_FACE_WORDS : VCT_FACE_WORDS; }
    const FaceCapacities& capacities() const { return capacities_; }
    // The number of faces' ids: of static faces, and twice of dynamic ones.
    std::uint32_t idCapacity() const { return capacities_[0] + 2 * capacities_[VCT_LIST_DYNAMIC]; }

    bool hasDynamicObjects() const { return !dynamicIndices_.empty(); }
    // The list of the dynamic objects in their present pose, and the texture of their occupied voxels in it.
    std::uint32_t dynamicList() const { return VCT_LIST_DYNAMIC + pose_; }
    const gl::Texture& dynamicIndex() const { return indexOfPose(pose_); }
    const gl::Texture& previousIndex() const { return indexOfPose(1 - pose_); }
    const gl::Texture& indexOf(std::uint32_t list) const {
        return list < VCT_LIST_DYNAMIC ? index_.texture() : dynamicIndex();
    }

    // Empties everything, and makes room for the static faces.
    void reset(const FaceCapacities& capacities);
    // Takes what is listed now for the static geometry, to which the lists return for each pose. Waits for
    // the GPU.
    void keepStatic();
    // Makes room for more faces of dynamic objects, which are removed. Waits for the GPU.
    void growDynamic(const FaceCapacities& capacities);
    // Removes the dynamic objects in their last pose. The faces that they shared with the static geometry
    // keep their radiance until light is injected.
    void beginPose();

    // All faces of the base level, at present: their list (shared::packFace(), without those that are merged)
    // and their ids. Waits for the GPU.
    struct BaseFace {
        std::uint32_t entry, id;
    };
    std::vector<BaseFace> readBaseFaces() const;
    // A level's list of faces. Waits for the GPU.
    std::vector<std::uint32_t> readFaceList(int level) const;

    void bindLevel(int unit, int level) const;
    // The lists of voxels and faces, the faces' words and their range, for shaders.
    void bindLists() const;

  private:
    const gl::Texture& indexOfPose(std::uint32_t pose) const {
        return dynamicIndices_.empty() ? index_.texture() : dynamicIndices_[pose];
    }
    void placeLists(shared::CommandLists& commands) const;
    std::size_t words() const;

    bool emission_;
    VoxelPyramid index_;
    gl::Texture faces_;
    std::vector<gl::Texture> dynamicIndices_;  // of the present pose and the one before, in turn
    gl::Buffer faceData_, range_;
    FaceCapacities capacities_{};
    std::uint32_t pose_ = 0;
    gl::Program clearDynamic_, clearLevel_, resetLists_;  // where there are dynamic objects
};

}  // namespace vct
