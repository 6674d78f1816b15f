// The parameters of the present light step.
#include "shared/layout.h"

layout(std140, binding = VCT_UBO_LIGHT) uniform LightBlock {
    LightStep lightStep;
};
