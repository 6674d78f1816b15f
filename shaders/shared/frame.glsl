// What every pass of a frame knows: camera, light, volume and settings (jni/engine/frame_uniforms.h).
#include "shared/layout.h"

layout(std140, binding = VCT_UBO_FRAME) uniform FrameBlock {
    FrameUniforms frame;
};
