#include "lab/voxel_view.h"

#include <algorithm>
#include <iterator>

#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/render_pass.h"

namespace vct {

namespace {
// Corner i of the cube is (i & 1, i >> 1 & 1, i >> 2 & 1).
constexpr GLushort cube[36] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                               2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
}  // namespace

gl::ProgramDescription voxelViewProgram() {
    return {"voxel_view", {"lab/voxel_view.vert", "lab/voxel_view.frag"}, {}};
}

VoxelView::VoxelView(const gl::ShaderLibrary& shaders, glm::ivec2 size)
    : program_(shaders, voxelViewProgram()),
      color_(gl::Texture::make2d("voxel view", GL_RGBA16F, size.x, size.y)),
      depth_(gl::Texture::make2d("voxel view depth", GL_DEPTH_COMPONENT24, size.x, size.y)),
      framebuffer_("voxel view", {&color_}, &depth_) {
    vertexArray_.bind();
    indices_ = gl::Buffer("cube", GL_ELEMENT_ARRAY_BUFFER, sizeof cube, cube, GL_STATIC_DRAW);
}

const gl::Texture& VoxelView::draw(const VoxelPyramid& voxels, int level,
                                   const std::vector<std::uint32_t>& list) {
    const gl::DebugGroup group("voxel view");
    const gl::RenderPass pass(framebuffer_, gl::Load::clear, gl::Store::colors);
    program_.use();
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
    voxels.texture().bind(VCT_TEX_VOXELS);
    vertexArray_.bind();
    indices_.bind(GL_ELEMENT_ARRAY_BUFFER);  // a driver fault requires this: see GpuScene::bindGeometry()
    list_ = gl::Buffer("listed voxels", GL_ARRAY_BUFFER, list.size() * sizeof list[0], list.data(),
                       GL_STREAM_DRAW);
    gl::EnableVertexAttribArray(VCT_ATTRIBUTE_VOXEL);
    gl::VertexAttribIPointer(VCT_ATTRIBUTE_VOXEL, 1, GL_UNSIGNED_INT, 0, nullptr);
    gl::VertexAttribDivisor(VCT_ATTRIBUTE_VOXEL, 1);
    gl::DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(std::size(cube)), GL_UNSIGNED_SHORT, nullptr,
                              static_cast<GLsizei>(list.size()));
    return color_;
}

}  // namespace vct
