// The intermediates of a frame as pictures for people.
#pragma once

#include "gl/program.h"
#include "image/image.h"

namespace vct {

// Draws one target through lab/debug_view.frag (`stage`: VCT_STAGE_*), the textures being bound by the
// caller.
Image drawDebugView(const gl::ShaderLibrary& shaders, int stage, glm::ivec2 size);

// Grey values between the smallest and the largest below 1 stretched to the whole range: depths lie close
// together. What is 1 (nothing there) stays white.
Image stretchDepth(const Image& depth);

}  // namespace vct
