// The uniforms that all passes of a frame share: camera, sun, volume and settings
// (jni/engine/frame_uniforms.h).
#include "shared/layout.h"

layout(std140, binding = VCT_UBO_FRAME) uniform FrameBlock {
    FrameUniforms frame;
};
