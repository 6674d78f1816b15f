// The textures and buffers of directional voxels: the index of occupied voxels, each with up to six one-sided
// faces; the faces' surfaces, materials and radiance by their ids; the face lists, and the sums of
// voxelization. Static geometry and dynamic objects have separate sums, which are combined after a pose has
// been voxelized. The layouts are described in shaders/directional: face_data.glsl, face_lists.glsl and
// face_sums.glsl.
#pragma once

#include <array>
#include <optional>

#include "engine/material_programs.h"
#include "engine/voxel_pyramid.h"
#include "scene/scene.h"

namespace vct {

// Fixed-point units of a fully covered face in the sums of voxelization: 65536, or fewer if the scene has so
// many triangles that a sum could overflow. (A triangle covers a face at most once.)
float faceSumUnits(std::size_t triangles);

gl::ProgramDescription clearDynamicProgram(bool emission);
gl::ProgramDescription clearBlocksProgram();
gl::ProgramDescription fillBlocksProgram(bool emission);
gl::ProgramDescription resolveProgram(bool emission);
gl::ProgramDescription extentsProgram(bool emission);
gl::ProgramDescription resetListsProgram();
gl::ProgramDescription markStaticProgram();
gl::ProgramDescription unlistStaticProgram(bool emission);
gl::ProgramDescription scrollProgram(bool emission);
gl::ProgramDescription listBlocksProgram();
gl::ProgramDescription listFreeProgram();
gl::ProgramDescription listFreshProgram();

// Capacities of the face lists, by list (VCT_LISTS).
using FaceCapacities = std::array<std::uint32_t, VCT_LISTS>;
// The moves of the cascades, in their voxels.
using CascadeShifts = std::array<glm::ivec3, VCT_MAX_CASCADES>;

class DirectionalVoxels {
  public:
    // `listCapacity`: capacity of the base level's active-voxel list, as in VoxelPyramid. `dynamicObjects`:
    // a part of the scene is voxelized in each pose. `emission`: surfaces emit light, so faces also have sums
    // of emission.
    DirectionalVoxels(const gl::ShaderLibrary& shaders, int grid, int cascades, std::uint32_t listCapacity,
                      bool dynamicObjects, bool emission);

    Resources resources() const;
    static std::size_t bytesFor(int grid, int cascades, std::uint32_t listCapacity);
    // A texture of the faces of blocks holds the six directions beside each other: three along x and two
    // along y. Cascades follow each other along z.
    static constexpr int directionsX = 3, directionsY = 2;

    int grid() const { return index_.grid(); }
    int cascades() const { return cascades_; }

    // The index of the static geometry's occupied voxels, and the commands of all lists.
    const VoxelPyramid& index() const { return index_; }
    // The occupied voxels of blocks, for rays: shaders/directional/fill_blocks.comp.
    const gl::Texture& blocks() const { return blocks_; }
    // The data of all faces, and the face lists: shaders/directional/face_data.glsl.
    const gl::Buffer& faceData() const { return faceData_; }
    // Words per face in faceData() besides its radiance, and the positions of a face's radiance and of the
    // first of the others.
    std::uint32_t faceWords() const { return emission_ ? VCT_EMISSIVE_FACE_WORDS : VCT_FACE_WORDS; }
    std::uint32_t radianceWord(std::uint32_t id) const {
        return firstFaceWord() + shared::faceRadianceWord(id, faceWords());
    }
    std::uint32_t faceWord(std::uint32_t id) const {
        return firstFaceWord() + shared::faceWord(id, faceWords());
    }
    std::uint32_t sumWords() const { return emission_ ? VCT_EMISSIVE_FACE_SUM_WORDS : VCT_FACE_SUM_WORDS; }
    const FaceCapacities& capacities() const { return capacities_; }
    // The lists of the base level in the order of their ids.
    static constexpr std::array<std::uint32_t, 3> baseLists{0, VCT_LIST_DYNAMIC, VCT_LIST_DYNAMIC + 1};
    // Number of face ids: one per static face, and one per dynamic face in each of two poses.
    std::uint32_t idCapacity() const { return capacities_[0] + 2 * capacities_[VCT_LIST_DYNAMIC]; }

    bool hasDynamicObjects() const { return dynamicObjects_; }
    // The list of the dynamic objects in the present pose. That of the static geometry is list 0.
    std::uint32_t dynamicList() const { return VCT_LIST_DYNAMIC + pose_; }
    // The index of the occupied voxels of a list: shaders/directional/index.glsl. The indices of the dynamic
    // lists alternate with them.
    const gl::Texture& indexOf(std::uint32_t list) const;
    // Its pages, of a dynamic list.
    const gl::Texture& pagesOf(std::uint32_t list) const;
    const gl::Texture& staticIndex() const { return indexOf(0); }
    const gl::Texture& dynamicIndex() const { return indexOf(dynamicList()); }
    const gl::Texture& dynamicPages() const { return pagesOf(dynamicList()); }

    // Number of pages of cascades, for blocks with static faces (shaders/directional/blocks.glsl).
    std::uint32_t pageCapacity() const { return pageCapacity_; }

    // Clears everything, and allocates buffers for these capacities.
    void reset(const FaceCapacities& capacities, std::uint32_t pages);
    // Marks the listed voxels and faces as static. The lists return to these counts for each pose.
    void markStatic() const;
    // Leaves room for the sums of the static faces that a move brings, once all of them or those of a long
    // move are resolved. reserveSums(): of at least so many.
    void shrinkSums();
    void reserveSums(std::uint32_t staticFaces);
    // Grows the lists to these capacities. What the present lists hold keeps its place in them, so that the
    // next voxelization finds it; faces that did not fit are missing until then. Waits for the GPU.
    void grow(const FaceCapacities& capacities, std::uint32_t pages);
    // Removes the dynamic objects of the last pose.
    void beginPose();
    // The same after cascades have moved: faces that a cascade has left are removed as well, and those that
    // it has reached can be added. `moved`: a bit for each cascade with a shift other than 0. `voxelized`:
    // the static faces that are voxelized next; shrinkSums() follows, unless these are few.
    enum class StaticFaces { ofMove, ofLongMove, all };
    void beginMove(const CascadeShifts& shifts, std::uint32_t moved, StaticFaces voxelized);
    static constexpr std::uint32_t allCascades = 0xFFFFFFFFU;
    // Writes the occupied voxels of blocks, and the surface and the material of each face, after static
    // geometry and pose have been voxelized. `changed`: the cascades whose static geometry has changed, a bit
    // for each. `objects`: around the dynamic objects in the pose, volume space.
    void resolve(std::uint32_t changed, const Bounds& objects);
    // Around the dynamic objects in the present pose, and the box to which the last resolve() was confined.
    const Bounds& objects() const { return objects_; }
    const Bounds& changed() const { return changed_; }

    // Tells the current program, or those of materials, the first id that has sums in one cube
    // (shaders/directional/face_sums.glsl). Cascades have no such uniform.
    void setFirstSums() const;
    void setFirstSums(const MaterialPrograms& programs) const;

    // Confines the current program, of directional/changed.glsl, to a box, volume space.
    static void setChanged(const Bounds& box);

    // Lists the static faces that have no light yet, in VCT_LIST_VISITED. Only with cascades.
    void listFresh() const;

    // Entries (shared::packFace()) and ids of the base level's faces in the present pose, without merged
    // faces. Waits for the GPU.
    struct BaseFace {
        std::uint32_t entry, id;
    };
    std::vector<BaseFace> readBaseFaces() const;
    // Entries (shared::packEntry()) of the voxels that have base faces, in ascending order. Waits for the
    // GPU.
    std::vector<std::uint32_t> readVoxels() const;
    // Entries of the faces of blocks. Waits for the GPU.
    std::vector<std::uint32_t> readBlockFaces() const;

    // Binds the indices of the static geometry and of the present pose.
    void bindIndices() const;
    // Binds the lists of voxels and faces, and the faces' data for shaders.
    void bindLists() const;
    // The same, and the faces' sums.
    void bindForVoxelization() const;
    // Binds the faces' data and the indices for rays (shaders/directional/ray.glsl).
    void bindForRays() const;

  private:
    void resetLists(bool withStatic);
    std::uint32_t firstWithSums() const { return sumsById_ ? 0 : capacities_[0]; }
    void makeSums(std::uint32_t staticFaces, bool byId);
    void resolveFaces(std::uint32_t list) const;
    // Dispatches the current program, of groups of 4^3 blocks, over so many layers of blocks.
    void dispatchOverBlocks(int layers) const;
    void placeLists(shared::CommandLists& commands) const;
    // Makes the indices of dynamic objects, without faces.
    void makeDynamicIndices();
    void writeIndex(std::uint32_t list, std::uint32_t firstId,
                    const std::vector<std::uint32_t>& entries) const;
    std::uint32_t firstFaceWord() const;
    std::uint32_t blockCount() const;
    std::size_t words() const;

    int cascades_;
    bool dynamicObjects_, emission_;
    VoxelPyramid index_;
    std::vector<gl::Texture> dynamicIndices_,
        dynamicPages_;                // two each, alternately of the present pose and the last one
    gl::Buffer faceData_, faceSums_;  // shaders/directional/face_sums.glsl
    bool sumsById_ = true;
    std::uint32_t sumCapacity_ = 0;  // static faces that a move may bring
    FaceCapacities capacities_{};
    std::uint32_t pageCapacity_ = 0;
    std::uint32_t pose_ = 0;
    Bounds objects_ = noBounds, changed_ = noBounds;
    gl::Texture blocks_;  // shaders/directional/fill_blocks.comp
    gl::Program markStatic_, fillBlocks_, resolve_, extents_;
    gl::Program clearDynamic_, clearBlocks_, resetLists_;  // only with dynamic objects or cascades
    gl::Program unlistStatic_, scroll_, listFree_, listFresh_, listBlocks_;  // only with cascades
};

}  // namespace vct
