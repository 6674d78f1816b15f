// Directional coverage voxels: six faces per voxel, filterable, with mip levels, and the list of what is
// occupied. shaders/directional/voxels.glsl says what a face holds.
#pragma once

#include "engine/voxel_pyramid.h"
#include "scene/scene.h"

namespace vct {

// The fixed-point units of a whole face in the sums of voxelization: 4096, or fewer where a scene has so many
// triangles that a sum could overflow otherwise. (A triangle makes one fragment in a voxel at most.)
float faceSumUnits(std::size_t triangles);

// The radiance that the faces' 8 bits store as 1, relative to E/pi: what a white wall shines with in the sun
// and by bounces, or the brightest emitter or white wall beside a lamp, and what goes round of the light of
// all of them, as in a closed room, and the sky (scene's unit). What is brighter still is cut off. Above 0,
// also in the dark.
float faceRadianceRange(const Scene& scene, const DirectionalLight& light, const glm::vec3& skyRadiance,
                        int grid);

// Room for a count of voxels that changes: so much more that it rarely grows again.
std::uint32_t withHeadRoom(std::uint32_t count);

gl::ProgramDescription directionalClearProgram();
gl::ProgramDescription directionalClearBaseProgram();

class DirectionalVoxels {
  public:
    // `listCapacity`: of the base level's list, as for VoxelPyramid.
    DirectionalVoxels(const gl::ShaderLibrary& shaders, int grid, std::uint32_t listCapacity);

    Resources resources() const;
    static std::size_t bytesFor(int grid, std::uint32_t listCapacity);
    // The faces' texture holds six blocks of grid^3 texels, so many along x and y.
    static constexpr int blocksX = 3, blocksY = 2;
    static gl::Texture texture(const std::string& label, int grid, int levels);

    int grid() const { return index_.grid(); }
    int levels() const { return faces_.levels(); }

    // RGBA8, 3 x 2 blocks of grid^3, sampled trilinearly.
    const gl::Texture& faces() const { return faces_; }
    // Which voxels are occupied, their lists, and at the base level each voxel's place in the list + 1.
    const VoxelPyramid& index() const { return index_; }
    // What voxelization adds up per occupied voxel, and the lists of faces:
    // shaders/directional/face_sums.glsl, face_list.glsl. Empty before makeRoom().
    const gl::Buffer& sums() const { return sums_; }

    // Empties voxels, faces and sums, through the last frame's lists.
    void clear();
    // Says which entries of the lists are active: VoxelPyramid::readCommands().
    void setCommands(const std::vector<shared::LevelCommands>& commands) { index_.setCommands(commands); }
    // Of how many voxels there is room for sums and faces, the first ones in the base level's list.
    std::uint32_t places() const { return places_; }
    // Makes that room. Sums and lists of faces that there were are gone.
    void makeRoom(std::uint32_t voxels);
    // A level's list of faces, as shared::packFace() makes it. Waits for the GPU.
    std::vector<std::uint32_t> readFaceList(int level) const;

    void bindLevel(int unit, int level) const;
    // The lists of voxels and faces, and the sums, for shaders.
    void bindLists() const;

  private:
    VoxelPyramid index_;
    gl::Texture faces_;
    gl::Buffer sums_;
    std::uint32_t places_ = 0;  // of voxels in it
    gl::Program clearBase_, clear_;
};

}  // namespace vct
