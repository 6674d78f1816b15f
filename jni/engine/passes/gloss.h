// Reflections of glossy surfaces by rays: a part of the last pass. Rough surfaces have wide lobes, so their
// rays are traced in half the resolution first, and filtered; another draw traces those of smooth surfaces
// and adds both to the picture. All take scenes with glossy materials only.
#pragma once

#include <map>

#include "engine/passes/g_buffer.h"
#include "engine/programs.h"
#include "engine/voxel_volume.h"
#include "gl/program.h"

namespace vct {

gl::ProgramDescription glossProgram(bool mappedNormals, const LightFeatures& lights);
gl::ProgramDescription markGlossProgram();
gl::ProgramDescription halfGlossProgram(bool mappedNormals, const LightFeatures& lights);
gl::ProgramDescription filterGlossProgram(bool mappedNormals, const LightFeatures& lights);

class Gloss {
  public:
    Gloss(gl::ShaderLibrary shaders, const LightFeatures& lights, const gl::Texture& picture);

    // Traces the rays of rough surfaces, and filters them. `surface` has gloss.
    void traceRough(const GBuffer::Targets& surface, const VoxelLight& light);
    // The picture, and a depth target that the caller sets above 0.5 in pixels that have a ray. It is lost
    // after the render pass.
    const gl::Framebuffer& framebuffer() const { return pictureAndMask_; }
    // Adds all reflections to the picture. Call it in a render pass into framebuffer(), with the inputs of
    // traceRough().
    void add(const GBuffer::Targets& surface, const VoxelLight& light);

    // Recreates the targets for a picture of another size.
    void resize(const gl::Texture& picture);
    Resources resources() const;

  private:
    struct Programs {
        gl::Program mark, half, filter, full;
    };
    const Programs& programs(bool mappedNormals);

    gl::ShaderLibrary shaders_;
    LightFeatures lights_;
    std::map<bool, Programs> programs_;  // by mapped normals; compiled on first use
    gl::Texture half_, filtered_;        // RGBA16F, see gloss_half.frag and gloss_filter.frag
    gl::Texture halfMask_, mask_;        // depth targets, above 0.5 in pixels that have a ray
    gl::Framebuffer halfFramebuffer_, filteredFramebuffer_, pictureAndMask_;
    gl::VertexArray noVertices_;
};

}  // namespace vct
