// Fragments of all shadow maps. Only depth is written. Holes of alpha-masked surfaces let the light through.
#include "shared/counters.glsl"
#include "shared/material.glsl"

void main() {
    COUNT(VCT_COUNTER_SHADOW_MAP);
    if (materialHasHoles && materialIsHole(materialBaseColor().a)) discard;
}
