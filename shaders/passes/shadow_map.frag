// Only depth is written; holes of alpha-masked surfaces let the light through.
#include "shared/counters.glsl"

#ifdef VCT_ALPHA_MASK
#include "shared/material.glsl"

in vec2 fragmentUv;

void main() {
    COUNT(VCT_COUNTER_SHADOW_MAP);
    if (materialIsHole(materialBaseColor(fragmentUv).a)) discard;
}
#else
void main() {
    COUNT(VCT_COUNTER_SHADOW_MAP);
}
#endif
