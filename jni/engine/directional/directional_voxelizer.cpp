#include "engine/directional/directional_voxelizer.h"

#include <algorithm>
#include <cmath>

#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/render_pass.h"

namespace vct {

namespace {

// Sixteen samples per voxel and axis, so that the coverage of a face has steps of 1/16, and the edge of a
// closed box has no slit of more than an eighth of a voxel through which light leaks.
glm::ivec4 viewportFor(int grid, int pixelSamples) {
    const int side = (pixelSamples == 1 ? 4 : 2) * grid;
    return {0, 0, side, side};
}

}  // namespace

gl::ProgramDescription markFacesProgram(unsigned features) {
    const unsigned used =
        (features & featureAlphaMask) ? holeFeatures | featureDoubleSided : unsigned{featureDoubleSided};
    return voxelizing("directional/mark_faces", featureDefines(features, used), Voxelization::sortedAxes);
}

gl::ProgramDescription listFacesProgram(bool emission) {
    return {"directional/list_faces", {"directional/list_faces.comp"}, emissionDefines(emission)};
}

gl::ProgramDescription accumulateProgram(unsigned features, bool emission) {
    return voxelizing(
        "directional/accumulate",
        featureDefines(features, voxelFeatures & ~unsigned{featurePunctualLights}, emissionDefines(emission)),
        Voxelization::sortedAxes);
}

FaceProjection::FaceProjection(int grid, int pixelSamples)
    : viewport_(viewportFor(grid, pixelSamples)),
      framebuffer_("face voxelizer", viewport_.z, viewport_.w, pixelSamples) {}

int FaceProjection::sideFor(int grid, int pixelSamples) {
    return viewportFor(grid, pixelSamples).z;
}

void FaceProjection::use() const {
    const gl::RenderPass pass(framebuffer_);  // only sets GL state
    gl::Viewport(viewport_.x, viewport_.y, viewport_.z, viewport_.w);
}

DirectionalVoxelizer::DirectionalVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                                           int pixelSamples, bool emission)
    : grid_(grid),
      markFaces_(shaders, scene, markFacesProgram),
      accumulate_(shaders, scene, [=](unsigned features) { return accumulateProgram(features, emission); }),
      listFaces_(shaders, listFacesProgram(emission)),
      projection_(grid, pixelSamples) {}

void DirectionalVoxelizer::drawIntoCascades(const GpuScene& scene, const MaterialPrograms& programs,
                                            ScenePart part, const Region& region) const {
    const Cascades& cascades = region.cascades;
    for (int cascade = 0; cascade < cascades.count(); ++cascade) {
        if ((region.moved >> cascade & 1U) == 0) continue;
        const glm::dvec3& corner = cascades.corner(cascade);
        const double side = cascades.side(cascade);
        Bounds drawn{corner, corner + side};
        if (cascades.count() > 1) {
            // After a move along one axis, what is new is a slab. After others it is not a box.
            glm::ivec3 shift(grid_);
            if (region.shifts != nullptr) shift = region.shifts->at(static_cast<std::size_t>(cascade));
            for (int axis = 0; axis < 3; ++axis) {
                if (glm::abs(shift)[axis] != glm::abs(shift.x) + glm::abs(shift.y) + glm::abs(shift.z))
                    continue;
                const double width = side / grid_ * std::min(std::abs(shift[axis]), grid_);
                if (shift[axis] > 0) drawn.min[axis] = drawn.max[axis] - width;
                if (shift[axis] < 0) drawn.max[axis] = drawn.min[axis] + width;
            }
            programs.setUniform(VCT_UNIFORM_CASCADE, static_cast<GLuint>(cascade));
            programs.setUniform(VCT_UNIFORM_SHIFT, shared::packShift(shift));
        }
        scene.drawForVoxels(programs, DrawRegion::box(drawn), part);
    }
}

void DirectionalVoxelizer::listFaces(const GpuScene& scene, ScenePart part, std::uint32_t list,
                                     const DirectionalVoxels& voxels, const Region& region) const {
    const gl::DebugGroup group("list faces");
    projection_.use();
    voxels.bindForVoxelization();
    voxels.staticIndex().bind(VCT_TEX_VOXELS);
    markFaces_.setUniform(VCT_UNIFORM_LIST, list);
    drawIntoCascades(scene, markFaces_, part, region);
    // The next pass reads the marks, and is dispatched by the commands.
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    listFaces_.use();
    gl::Uniform1ui(VCT_UNIFORM_LIST, list);
    voxels.indexOf(list).bindImage(VCT_IMAGE_VOXELS, 0, GL_WRITE_ONLY);
    if (list != 0) voxels.pagesOf(list).bindImage(VCT_IMAGE_PAGES, 0, GL_WRITE_ONLY);
    voxels.index().dispatchOverMarkedBlocks();
    // Later passes fetch from the index texture, read the lists and are dispatched over them. The debug view
    // draws the listed voxels.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

void DirectionalVoxelizer::accumulate(const GpuScene& scene, ScenePart part, std::uint32_t list,
                                      const DirectionalVoxels& voxels, const Region& region) const {
    const gl::DebugGroup group("accumulate");
    projection_.use();
    voxels.bindForVoxelization();
    voxels.bindIndices();
    accumulate_.setUniform(VCT_UNIFORM_LIST, list);
    voxels.setFirstSums(accumulate_);
    drawIntoCascades(scene, accumulate_, part, region);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace vct
