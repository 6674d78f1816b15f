// Fragments of all shadow maps. Only depth is written. Holes of alpha-masked surfaces let the light through.
#include "shared/material.glsl"

void main() {
    if (materialHasHoles && materialIsHole(materialBaseColor().a)) discard;
}
