// The parts of the compact emitters (jni/engine/emitters.h).
#include "directional/cascades.glsl"

layout(std140, binding = VCT_UBO_EMITTERS) uniform EmittersBlock {
    EmitterBlock emitters;
};

// The projected area of a distant part, seen along the unit vector `towards` it: the projected flat area, and
// a quarter of the closed convex area (Cauchy).
float projectedArea(EmitterPartUniforms part, vec3 towards) {
    return max(-dot(part.facing.xyz, towards), 0.0) + part.facing.w;
}
