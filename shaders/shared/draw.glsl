// The uniforms of one draw call.
#include "shared/layout.h"

layout(std140, binding = VCT_UBO_DRAW) uniform DrawBlock {
    DrawUniforms draw;
};
