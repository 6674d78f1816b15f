// Fragments of a punctual light's shadow map. Holes of alpha-masked surfaces let the light through.
#include "shared/material.glsl"

in highp float storedDepth;

void main() {
    if (materialHasHoles && materialIsHole(materialBaseColor().a)) discard;
    gl_FragDepth = storedDepth;
}
