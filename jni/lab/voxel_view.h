// Draws the active voxels of one mip level as cubes.
#pragma once

#include "engine/voxel_pyramid.h"
#include "gl/program.h"

namespace vct {

gl::ProgramDescription voxelViewProgram();

class VoxelView {
  public:
    VoxelView(const gl::ShaderLibrary& shaders, glm::ivec2 size);

    // Draws the listed voxels of a level (shared::packEntry()) from the renderer's camera. Returns an RGBA16F
    // texture; rgb is relative to E/pi.
    const gl::Texture& draw(const VoxelPyramid& voxels, int level, const std::vector<std::uint32_t>& list);

  private:
    gl::Program program_;
    gl::Texture color_, depth_;
    gl::Framebuffer framebuffer_;
    gl::Buffer indices_, list_;
    gl::VertexArray vertexArray_;
};

}  // namespace vct
