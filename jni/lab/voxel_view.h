// Draws the active voxels of one mip level as cubes.
#pragma once

#include "engine/voxel_pyramid.h"
#include "gl/program.h"

namespace vct {

gl::ProgramDescription voxelViewProgram();

class VoxelView {
  public:
    VoxelView(const gl::ShaderLibrary& shaders, glm::ivec2 size);

    // Draws a level from the renderer's camera. Waits for the GPU to read the number of voxels. Returns an
    // RGBA16F texture; rgb is relative to E/pi.
    const gl::Texture& draw(const VoxelPyramid& voxels, int level);

  private:
    gl::Program program_;
    gl::Texture color_, depth_;
    gl::Framebuffer framebuffer_;
    gl::Buffer indices_;
    gl::VertexArray vertexArray_;
};

}  // namespace vct
