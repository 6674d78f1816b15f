// Only depth is written; holes of alpha-masked surfaces let the light through.
#ifdef VCT_ALPHA_MASK
#include "shared/material.glsl"

in vec2 fragmentUv;

void main() {
    if (materialIsHole(materialBaseColor(fragmentUv).a)) discard;
}
#else
void main() {}
#endif
