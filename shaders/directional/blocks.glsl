// The uniform blocks of shared/layout.h.
#include "shared/layout.h"

layout(std140, binding = VCT_UBO_FRAME) uniform FrameBlock {
    FrameUniforms frame;
};
