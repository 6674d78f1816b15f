#include "engine/directional/directional_voxelizer.h"

#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/render_pass.h"

namespace vct {

namespace {

// Two pixels per voxel and axis, so that the coverage of a face has steps of a quarter.
glm::ivec4 viewportFor(int grid) {
    return {0, 0, 2 * grid, 2 * grid};
}

}  // namespace

gl::ProgramDescription markFacesProgram(unsigned features) {
    const unsigned used =
        (features & featureAlphaMask) ? holeFeatures | featureDoubleSided : unsigned{featureDoubleSided};
    return voxelizing("directional/mark_faces", featureDefines(features, used), Voxelization::sortedAxes);
}

gl::ProgramDescription listFacesProgram() {
    return {"directional/list_faces", {"directional/list_faces.comp"}, {}};
}

gl::ProgramDescription keepVoxelsProgram() {
    return {"directional/keep_voxels", {"directional/keep_voxels.comp"}, {}};
}

gl::ProgramDescription keepSumsProgram(bool emission) {
    return {"directional/keep_sums", {"directional/keep_sums.comp"}, emissionDefines(emission)};
}

gl::ProgramDescription accumulateProgram(unsigned features, bool emission) {
    return voxelizing(
        "directional/accumulate",
        featureDefines(features, voxelFeatures & ~unsigned{featurePunctualLights}, emissionDefines(emission)),
        Voxelization::sortedAxes);
}

FaceProjection::FaceProjection(int grid)
    : viewport_(viewportFor(grid)), framebuffer_("face voxelizer", sideFor(grid), sideFor(grid)) {}

int FaceProjection::sideFor(int grid) {
    const glm::ivec4 viewport = viewportFor(grid);
    return viewport.x + viewport.z;
}

void FaceProjection::use() const {
    const gl::RenderPass pass(framebuffer_);  // without attachments, the pass only sets GL state
    gl::Viewport(viewport_.x, viewport_.y, viewport_.z, viewport_.w);
}

DirectionalVoxelizer::DirectionalVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                                           int cascades, bool emission)
    : markFaces_(shaders, scene, markFacesProgram),
      accumulate_(shaders, scene, [=](unsigned features) { return accumulateProgram(features, emission); }),
      listFaces_(shaders, listFacesProgram()),
      projection_(grid) {
    if (cascades == 1) return;
    keepVoxels_ = gl::Program(shaders, keepVoxelsProgram());
    keepSums_ = gl::Program(shaders, keepSumsProgram(emission));
}

void DirectionalVoxelizer::drawIntoCascades(const GpuScene& scene, const MaterialPrograms& programs,
                                            ScenePart part, const Cascades& cascades,
                                            std::uint32_t moved) const {
    for (int cascade = 0; cascade < cascades.count(); ++cascade) {
        if ((moved >> cascade & 1U) == 0) continue;
        if (cascades.count() > 1) programs.setUniform(VCT_UNIFORM_CASCADE, static_cast<GLuint>(cascade));
        scene.drawForVoxels(programs, DrawRegion::cube(cascades.corner(cascade), cascades.side(cascade)),
                            part);
    }
}

bool DirectionalVoxelizer::keeps(std::uint32_t list, const DirectionalVoxels& voxels, std::uint32_t moved) {
    const std::uint32_t all = (1U << voxels.cascades()) - 1U;
    return list >= VCT_LIST_STATIC && (moved & all) != all;
}

void DirectionalVoxelizer::listFaces(const GpuScene& scene, ScenePart part, std::uint32_t list,
                                     const DirectionalVoxels& voxels, const Cascades& cascades,
                                     std::uint32_t moved) const {
    const gl::DebugGroup group("list faces");
    projection_.use();
    voxels.bindForVoxelization();
    voxels.indexOf(list).bindImage(VCT_IMAGE_VOXELS, 0, GL_READ_WRITE);
    if (keeps(list, voxels, moved)) {
        keepVoxels_.use();
        voxels.indexOf(list ^ 1U).bind(VCT_TEX_PREVIOUS_VOXELS);
        gl::Uniform1ui(VCT_UNIFORM_CASCADES, moved);
        voxels.index().dispatchOverLevel(list ^ 1U);
    }
    markFaces_.setUniform(VCT_UNIFORM_LIST, list);
    drawIntoCascades(scene, markFaces_, part, cascades, moved);
    // The next pass loads from the index image, reads the list and is dispatched by the commands.
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                      GL_COMMAND_BARRIER_BIT);
    listFaces_.use();
    voxels.staticIndex().bind(VCT_TEX_VOXELS);
    voxels.index().dispatchOverLevel(list);
    // Later passes fetch from the index texture, read the lists and are dispatched over them. The debug view
    // draws the listed voxels.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

void DirectionalVoxelizer::accumulate(const GpuScene& scene, ScenePart part, std::uint32_t list,
                                      const DirectionalVoxels& voxels, const Cascades& cascades,
                                      std::uint32_t moved) const {
    const gl::DebugGroup group("accumulate");
    projection_.use();
    voxels.bindForVoxelization();
    if (keeps(list, voxels, moved)) {
        keepSums_.use();
        voxels.indexOf(list ^ 1U).bind(VCT_TEX_PREVIOUS_VOXELS);
        gl::Uniform1ui(VCT_UNIFORM_CASCADES, moved);
        voxels.index().dispatchOverFaces(0);
    }
    voxels.indexOf(list).bind(VCT_TEX_VOXELS);
    drawIntoCascades(scene, accumulate_, part, cascades, moved);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace vct
