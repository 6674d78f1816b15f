#include "engine/directional/directional_voxelizer.h"

#include "engine/packed/packed_voxelizer.h"
#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/render_pass.h"

namespace vct {

namespace {

// `side`: pixels of the projected volume. Software rasterizers work on tiles of 64 x 64 pixels side by side;
// a projection of 64 x 64 would be one tile, for one core, if it did not lie on the corner of four.
glm::ivec4 viewportFor(int side) {
    const int offset = side <= 64 ? 32 : 0;
    return {offset, offset, side, side};
}

}  // namespace

gl::ProgramDescription occupancyProgram(unsigned features, Voxelization voxelization) {
    if (!(features & featureAlphaMask)) features = 0;
    return voxelizing("directional/occupancy", featureDefines(features, holeFeatures), voxelization);
}

gl::ProgramDescription directionalVoxelizerProgram(unsigned features, Voxelization voxelization) {
    return voxelizing("directional/voxelizer", featureDefines(features, voxelFeatures, {"VCT_RELIGHT false"}),
                      voxelization);
}

gl::ProgramDescription directionalResolveProgram() {
    return {"directional/resolve", {"directional/resolve.comp"}, {"VCT_STATIC false"}};
}

FaceProjection::FaceProjection(int grid)
    : viewport_(viewportFor(grid)), framebuffer_("face voxelizer", sideFor(grid), sideFor(grid)) {}

int FaceProjection::sideFor(int grid) {
    const glm::ivec4 viewport = viewportFor(grid);
    return viewport.x + viewport.z;
}

void FaceProjection::use() const {
    const gl::RenderPass pass(framebuffer_);  // it has no attachments, so the pass is its state alone
    gl::Viewport(viewport_.x, viewport_.y, viewport_.z, viewport_.w);
}

DirectionalVoxelizer::DirectionalVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                                           Voxelization voxelization)
    : markOccupied_(shaders, scene,
                    [=](unsigned features) { return occupancyProgram(features, voxelization); }),
      accumulate_(shaders, scene,
                  [=](unsigned features) { return directionalVoxelizerProgram(features, voxelization); }),
      resolve_(shaders, directionalResolveProgram()),
      projection_(grid) {}

void DirectionalVoxelizer::run(const GpuScene& scene, const DirectLight& light, DirectionalVoxels& voxels) {
    const gl::DebugGroup group("voxelize");
    voxels.clear();
    markOccupied(scene, {}, voxels);
    if (voxels.places() == 0) voxels.makeRoom(voxels.index().readActiveCounts()[0]);
    accumulate(scene, {}, accumulate_, light, voxels);
    resolve(resolve_, voxels, [&] { voxels.index().dispatchOverLevel(0); });
}

void DirectionalVoxelizer::markOccupied(const GpuScene& scene, const ScenePart& part,
                                        DirectionalVoxels& voxels) const {
    projection_.use();
    voxels.index().bindLevel(VCT_IMAGE_VOXELS, 0, GL_READ_WRITE);
    voxels.index().bindLists();
    scene.drawForVoxels(markOccupied_, part, projection_.viewport());
    // Next: the places in the list are fetched as a texture.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void DirectionalVoxelizer::accumulate(const GpuScene& scene, const ScenePart& part,
                                      const MaterialPrograms& programs, const DirectLight& light,
                                      DirectionalVoxels& voxels) const {
    projection_.use();
    voxels.bindLists();
    light.sun.depth->bind(VCT_TEX_SHADOW_DEPTH);
    plainDepth_.bind(VCT_TEX_SHADOW_DEPTH);
    light.bindOthers();
    voxels.index().texture().bind(VCT_TEX_VOXELS);
    scene.drawForVoxels(programs, part, projection_.viewport());
}

void DirectionalVoxelizer::resolve(const gl::Program& program, DirectionalVoxels& voxels,
                                   const std::function<void()>& dispatch) const {
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    program.use();
    voxels.bindLevel(VCT_IMAGE_FACES, 0);
    voxels.index().bindLevel(VCT_IMAGE_VOXELS_NEXT, 1, GL_READ_WRITE);
    dispatch();
    // Next: the mipmapper fetches the faces, reads the lists and is dispatched by the commands.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace vct
